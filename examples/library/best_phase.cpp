// Finds the driving phase with which the swimmer of the paper (Pickl et al. 2017) is fastest, in exact Stokes
// flow to second order in the driving amplitude. Then evaluates the velocity at this phase with the full
// amplitude.
//
//   best-phase [AMPLITUDE]     amplitude of the driving forces; default: the paper's value

#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "beadswim/theory/question.hpp"

namespace {

using namespace beadswim;

void find_best_phase(CollinearSwimmer swimmer) {
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
  std::printf("phase %.0f degrees, velocity %.4g cells per step\n", best_phase, best_velocity);

  swimmer.phase = best_phase * std::numbers::pi / 180;
  const MobilityFunction mobility_at = [&](const LinePositions& x) { return exact_mobility(swimmer, x); };
  const double min_gap = 0.01 * swimmer.radius[0];
  const PeriodicMotion motion = periodic_motion(swimmer, rest_positions(swimmer), mobility_at, min_gap);
  std::printf("at this amplitude %.4g\n", motion.velocity);
}

}  // namespace

int main(int argc, char** argv) {
  const Layout layout = paper_single();
  const ThreeBeadSwimmer type = three_beads(layout.types.at("a"));
  CollinearSwimmer swimmer = collinear_swimmer(type, Vec3::UnitX(), layout.fluid.dynamic_viscosity());
  if (argc > 1) swimmer.amplitude.fill(std::atof(argv[1]));
  try {
    find_best_phase(swimmer);
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
