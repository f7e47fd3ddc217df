#include "beadswim/plan/velocity_roundoff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/lattice/trt.hpp"
#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/perturbation.hpp"

namespace beadswim {
namespace {

// Single precision, measured against double: errors of the velocity over the fastest bead's speed stayed
// below this, in one cycle, and drift of the fluid's mean velocity below this a step.
constexpr double error_over_bead_speed = 1e-8;
constexpr double drift_over_bead_speed = 1e-13;

// Double precision: error of the way in one cycle, from positions of some tens of cells.
constexpr double lost_way = 1e-13;  // [cell]

struct Speeds {
  double bead, swimmer;  ///< fastest bead, and the swimmer over a period [cell/step]
};

/// As if it were driven along its own line.
Speeds predicted_speeds(const SwimmerType& type, double viscosity) {
  const CollinearSwimmer swimmer = collinear_swimmer(type, Vec3::UnitX(), viscosity);
  const CollinearMobility mobility = rest_mobility(swimmer, rotne_prager);
  const Eigen::Vector3cd displacement = linear_response(swimmer, mobility.value).displacement;
  return {.bead = swimmer.angular_frequency() * displacement.cwiseAbs().maxCoeff(),
          .swimmer = std::abs(second_order_motion(swimmer, mobility).velocity)};
}

}  // namespace

double velocity_roundoff(const CoupledScene& scene, long steps_per_period, long steps) {
  double worst = 0;
  for (const SwimmerType& type : scene.types) {
    const Speeds speeds = predicted_speeds(type, lattice_viscosity(scene.relaxation_time));
    if (speeds.bead == 0) continue;  // not driven
    constexpr double none = 1e-12;   // of the bead's speed: zero but for roundoff
    const bool swims = speeds.swimmer > none * speeds.bead;
    if (scene.precision == Precision::fp64) {
      if (swims) worst = std::max(worst, lost_way / (speeds.swimmer * static_cast<double>(steps_per_period)));
      continue;
    }
    const double error = error_over_bead_speed + drift_over_bead_speed * static_cast<double>(steps);
    worst = std::max(worst,
                     swims ? error * speeds.bead / speeds.swimmer : std::numeric_limits<double>::infinity());
  }
  return worst;
}

}  // namespace beadswim
