#pragma once

#include <array>

#include "beadswim/core/kernel.hpp"

// The D3Q19 lattice: velocities c_i and weights w_i. The squared speed of sound is c_s^2 = 1/3 cell^2/step^2
// (Qian, d'Humieres & Lallemand 1992).
//
// Direction 0 has velocity zero. Directions 2k-1 and 2k are opposite, because the two-relaxation-time
// collision processes such pairs. All quantities are in lattice units: cell = 1, step = 1, mean density = 1.

namespace beadswim::d3q19 {

inline constexpr int directions = 19;

// clang-format off
inline constexpr std::array<std::array<int, 3>, directions> velocity{{
    { 0,  0,  0},
    { 1,  0,  0}, {-1,  0,  0},   { 0,  1,  0}, { 0, -1,  0},   { 0,  0,  1}, { 0,  0, -1},
    { 1,  1,  0}, {-1, -1,  0},   { 1, -1,  0}, {-1,  1,  0},
    { 1,  0,  1}, {-1,  0, -1},   { 1,  0, -1}, {-1,  0,  1},
    { 0,  1,  1}, { 0, -1, -1},   { 0,  1, -1}, { 0, -1,  1},
}};

inline constexpr double weight_rest     = 1.0 / 3.0;
inline constexpr double weight_axis     = 1.0 / 18.0;
inline constexpr double weight_diagonal = 1.0 / 36.0;
// clang-format on

constexpr double weight(int i) {
  return i == 0 ? weight_rest : (i < 7 ? weight_axis : weight_diagonal);
}

constexpr int opposite(int i) {
  return i == 0 ? 0 : ((i - 1) ^ 1) + 1;
}

/// Returns the direction with velocity (cx, cy, cz), or -1 if the lattice has no such direction.
constexpr int direction_of(int cx, int cy, int cz) {
  for (int i = 0; i < directions; ++i) {
    if (velocity[i][0] == cx && velocity[i][1] == cy && velocity[i][2] == cz) return i;
  }
  return -1;
}

/// Returns the mirror image of direction i: component `axis` (0, 1, 2) of c_i changes its sign.
constexpr int mirrored(int i, int axis) {
  std::array<int, 3> c = velocity[i];
  c[axis] = -c[axis];
  return direction_of(c[0], c[1], c[2]);
}

namespace identities {

constexpr bool near(double a, double b) {
  return a - b < 1e-15 && b - a < 1e-15;
}

/// Returns the lattice moment sum_i w_i c_ia^p c_ib^q, where w_i is the weight of direction i and c_ia the
/// component a of its velocity.
constexpr double moment(int a, int p, int b, int q) {
  double sum = 0;
  for (int i = 0; i < directions; ++i) {
    double term = weight(i);
    for (int n = 0; n < p; ++n) term *= velocity[i][a];
    for (int n = 0; n < q; ++n) term *= velocity[i][b];
    sum += term;
  }
  return sum;
}

constexpr bool opposites_are_opposite() {
  for (int i = 0; i < directions; ++i) {
    for (int a = 0; a < 3; ++a) {
      if (velocity[opposite(i)][a] != -velocity[i][a]) return false;
    }
  }
  return true;
}

static_assert(opposites_are_opposite());
static_assert(near(moment(0, 0, 1, 0), 1));                                             // sum w = 1
static_assert(near(moment(0, 2, 1, 0), 1.0 / 3) && near(moment(2, 2, 1, 0), 1.0 / 3));  // c_s^2
static_assert(near(moment(0, 1, 1, 1), 0) && near(moment(1, 1, 2, 1), 0));              // isotropy, order 2
static_assert(near(moment(0, 4, 1, 0), 1.0 / 3) && near(moment(0, 2, 1, 2), 1.0 / 9));  // isotropy, order 4

}  // namespace identities
}  // namespace beadswim::d3q19

namespace beadswim {

/// Evaluates the moments r = sum f_i (density minus 1) and u = sum c_i f_i (momentum) of one cell from its
/// populations f_i minus their weights w_i. The order of the additions is fixed, so that the bits are
/// reproducible. Value: double, or a vector of doubles with one lane per cell.
template <class Value>
BEADSWIM_KERNEL void moments_of(const Value (&f)[d3q19::directions], Value& r, Value (&u)[3]) {
  r = f[0];
  u[0] = u[1] = u[2] = Value{};
#pragma GCC unroll 19
  for (int i = 1; i < d3q19::directions; ++i) {
    r += f[i];
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      if (d3q19::velocity[i][a] == 1) u[a] += f[i];
      if (d3q19::velocity[i][a] == -1) u[a] -= f[i];
    }
  }
}

}  // namespace beadswim
