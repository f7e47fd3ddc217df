// With which phase of its driving does the paper's swimmer swim fastest? In exact Stokes flow, second order in amplitude.

#include <cstdio>
#include <numbers>

#include "beadswim/scene/presets.hpp"
#include "beadswim/theory/perturbation.hpp"
#include "beadswim/theory/question.hpp"

int main() {
  using namespace beadswim;
  const Layout layout = paper_single();
  CollinearSwimmer swimmer =
      collinear_swimmer(layout.types.at("a"), Vec3::UnitX(), layout.fluid.dynamic_viscosity());
  const CollinearMobility mobility = exact_mobility(swimmer, rest_positions(swimmer));
  double best_phase = 0, best_velocity = 0;
  for (int degrees = 0; degrees < 360; ++degrees) {
    swimmer.phase = degrees * std::numbers::pi / 180;
    const double velocity = second_order_motion(swimmer, mobility).velocity;
    if (velocity > best_velocity) {
      best_velocity = velocity;
      best_phase = degrees;
    }
  }
  std::printf("phase %.0f degrees, velocity %.4g cells a step\n", best_phase, best_velocity);
}
