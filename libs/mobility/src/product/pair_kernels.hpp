#pragma once

#include "beadswim/core/kernel.hpp"
#include "mobility_kernels.hpp"

// Kernels of pairs of spheres on which forces act. Only for files that are compiled once per instruction set.

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

/// Rounds to the nearest integer, for |value| < 2^51.
BEADSWIM_KERNEL double rounded(double value) {
  constexpr double shift = 0x1.8p52;
  return (value + shift) - shift;
}

int find_near_spheres(const SortedSpheres& spheres, int one, int begin, int end, double cutoff,
                      PairBatch& batch) {
  constexpr int chunk = 128;
  double d[3][chunk], r2[chunk];
  const double at[3]{spheres.x[one], spheres.y[one], spheres.z[one]};
  double inverse[3];
  for (int a = 0; a < 3; ++a) inverse[a] = spheres.lengths[a] > 0 ? 1 / spheres.lengths[a] : 0;
  const double limit = cutoff * cutoff;
  const unsigned char wanted = spheres.is_receiver[one];
  for (; begin < end && batch.count + chunk <= PairBatch::capacity; begin += chunk) {
    const int n = end - begin < chunk ? end - begin : chunk;
    const double* const places[3]{spheres.x + begin, spheres.y + begin, spheres.z + begin};
    for (int t = 0; t < n; ++t) r2[t] = 0;
    for (int a = 0; a < 3; ++a) {
      for (int t = 0; t < n; ++t) {
        double along = at[a] - places[a][t];
        along -= spheres.lengths[a] * rounded(along * inverse[a]);
        d[a][t] = along;
        r2[t] += along * along;
      }
    }
    int count = batch.count;
    for (int t = 0; t < n; ++t) {
      batch.other[count] = begin + t;
      batch.d[0][count] = d[0][t];
      batch.d[1][count] = d[1][t];
      batch.d[2][count] = d[2][t];
      batch.r2[count] = r2[t];
      count += (r2[t] < limit) & (wanted | spheres.is_receiver[begin + t]);
    }
    batch.count = count;
  }
  return begin < end ? begin : end;
}

template <int functions>
BEADSWIM_KERNEL void pair_velocities_of(const PairTable& table, const double* force, PairBatch& b,
                                        double* velocity) {
  const double* const coefficients = table.coefficients;
  const std::int64_t first = table.first;
  const double fx = force[0], fy = force[1], fz = force[2];
  double sx = 0, sy = 0, sz = 0;
#pragma omp simd reduction(+ : sx, sy, sz)
  for (int t = 0; t < b.count; ++t) {
    const std::int64_t bits = __builtin_bit_cast(std::int64_t, b.r2[t]);
    constexpr std::int64_t fraction = (std::int64_t{1} << 52) - 1, one = std::int64_t{0x3ff} << 52;
    const std::int64_t within = ((bits << PairTable::stretch_bits) & fraction) | one;
    const double p = __builtin_bit_cast(double, within) - 1;
    const double* c =
        coefficients + ((bits >> PairTable::shift) - first) * (functions * (PairTable::degree + 1));
    double value[functions];
#pragma GCC unroll 6
    for (int f = 0; f < functions; ++f) value[f] = c[PairTable::degree * functions + f];
#pragma GCC unroll 6
    for (int k = PairTable::degree - 1; k >= 0; --k) {
#pragma GCC unroll 6
      for (int f = 0; f < functions; ++f) value[f] = value[f] * p + c[k * functions + f];
    }
    double isotropic = value[0], axial = value[1];
    if constexpr (functions >= 4) {
      isotropic += b.squares[t] * value[2];
      axial += b.squares[t] * value[3];
    }
    if constexpr (functions == 6) {
      isotropic += b.products[t] * value[4];
      axial += b.products[t] * value[5];
    }
    const double dx = b.d[0][t], dy = b.d[1][t], dz = b.d[2][t];
    const double gx = b.force[0][t], gy = b.force[1][t], gz = b.force[2][t];
    const double along = axial * (dx * fx + dy * fy + dz * fz);
    b.velocity[0][t] = isotropic * fx + along * dx;
    b.velocity[1][t] = isotropic * fy + along * dy;
    b.velocity[2][t] = isotropic * fz + along * dz;
    const double back = axial * (dx * gx + dy * gy + dz * gz);
    sx += isotropic * gx + back * dx;
    sy += isotropic * gy + back * dy;
    sz += isotropic * gz + back * dz;
  }
  velocity[0] += sx;
  velocity[1] += sy;
  velocity[2] += sz;
}

void pair_velocities(const PairTable& table, const double* force, PairBatch& batch, double* velocity) {
  table.functions == 2   ? pair_velocities_of<2>(table, force, batch, velocity)
  : table.functions == 4 ? pair_velocities_of<4>(table, force, batch, velocity)
                         : pair_velocities_of<6>(table, force, batch, velocity);
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
