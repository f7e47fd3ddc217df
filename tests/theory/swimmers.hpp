#pragma once

#include <numbers>
#include <utility>

#include "beadswim/collinear/oseen.hpp"
#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/methods.hpp"

namespace beadswim {

/// Returns the swimmer of section 4.2 of the paper in lattice units with unit driving amplitudes: velocities
/// are v/A^2, amplitudes d/A.
inline CollinearSwimmer paper_swimmer(double period) {
  return {.radius = {4, 4, 4},
          .density = {1, 1, 1},
          .arm = {20, 20},
          .stiffness = {0.0347, 0.0347},
          .damping = {0, 0},
          .amplitude = {1, 1},
          .phase = std::numbers::pi / 2,
          .period = period,
          .viscosity = 1.0 / 3};
}

/// Returns a swimmer in which no two parameters are equal and none is zero.
inline CollinearSwimmer unequal_swimmer() {
  return {.radius = {4, 3, 5},
          .density = {1, 1, 1},
          .arm = {20, 26},
          .stiffness = {0.03, 0.05},
          .damping = {7, 3},
          .amplitude = {1, 0.6},
          .phase = 1.1,
          .period = 3000,
          .viscosity = 1.0 / 3};
}

/// Returns the mirror image of the swimmer: beads and arms in reverse order.
inline CollinearSwimmer mirrored(const CollinearSwimmer& s) {
  CollinearSwimmer m = s;
  std::swap(m.radius[0], m.radius[2]);
  std::swap(m.density[0], m.density[2]);
  std::swap(m.arm[0], m.arm[1]);
  std::swap(m.stiffness[0], m.stiffness[1]);
  std::swap(m.damping[0], m.damping[1]);
  std::swap(m.amplitude[0], m.amplitude[1]);
  m.phase = -s.phase;  // bead 1 is now driven by B sin(wt + alpha): time shifted, A lags by alpha
  return m;
}

/// Returns the same swimmer in other units: the units are smaller by the factors `length`, `time` and `mass`.
inline CollinearSwimmer in_units(const CollinearSwimmer& s, double length, double time, double mass) {
  CollinearSwimmer u = s;
  for (double& radius : u.radius) radius *= length;
  for (double& density : u.density) density *= mass / (length * length * length);
  for (double& arm : u.arm) arm *= length;
  for (double& stiffness : u.stiffness) stiffness *= mass / (time * time);
  for (double& damping : u.damping) damping *= mass / time;
  for (double& amplitude : u.amplitude) amplitude *= mass * length / (time * time);
  u.period *= time;
  u.viscosity *= mass / (length * time);
  return u;
}

/// Returns a question for a swimmer in unbounded fluid.
inline Question ask(const CollinearSwimmer& swimmer, double fluid_density = 1) {
  return Question(swimmer, fluid_density);
}

inline Prediction prediction_of(const std::string& method, const CollinearSwimmer& swimmer) {
  return predict(find_method(method), ask(swimmer));
}

inline double perturbation_velocity(const CollinearSwimmer& swimmer, PairLaw law) {
  return second_order_motion(swimmer, rest_mobility(swimmer, law)).velocity;
}

}  // namespace beadswim
