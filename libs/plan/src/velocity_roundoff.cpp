#include "beadswim/plan/velocity_roundoff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/lattice/trt.hpp"
#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/perturbation.hpp"

namespace beadswim {
namespace {

// Upper bounds of errors of single precision, measured by comparison with double precision and divided by the
// speed of the fastest bead: the error of the velocity of a swimmer in one cycle, and the change of the mean
// fluid velocity per step.
constexpr double error_over_bead_speed = 1e-8;
constexpr double drift_over_bead_speed = 1e-13;

// Error of the displacement of a swimmer in one cycle in double precision, if coordinates are some tens of
// cells.
constexpr double displacement_error = 1e-13;  // [cell]

struct Speeds {
  double bead, swimmer;  ///< of the fastest bead; of the swimmer, period average [cell/step]
};

/// Returns the speeds of a swimmer of this type with the driving along its axis.
Speeds predicted_speeds(const SwimmerType& type, double viscosity) {
  const CollinearSwimmer swimmer = collinear_swimmer(three_beads(type), Vec3::UnitX(), viscosity);
  const CollinearMobility mobility = rest_mobility(swimmer, rotne_prager);
  const Eigen::Vector3cd displacement = linear_response(swimmer, mobility.value).displacement;
  return {.bead = swimmer.angular_frequency() * displacement.cwiseAbs().maxCoeff(),
          .swimmer = std::abs(second_order_motion(swimmer, mobility).velocity)};
}

}  // namespace

double velocity_roundoff(const CoupledScene& scene, long steps_per_period, long steps) {
  double worst = 0;
  for (const SwimmerType& type : scene.types) {
    if (!three_bead_form(type)) continue;  // theory does not predict its speeds
    const Speeds speeds = predicted_speeds(type, lattice_viscosity(scene.relaxation_time));
    if (speeds.bead == 0) continue;  // the type is not driven
    constexpr double none = 1e-12;   // smaller ratios of swimmer speed to bead speed are roundoff
    const bool is_swimming = speeds.swimmer > none * speeds.bead;
    if (scene.precision == Precision::fp64) {
      if (is_swimming)
        worst =
            std::max(worst, displacement_error / (speeds.swimmer * static_cast<double>(steps_per_period)));
      continue;
    }
    const double error = error_over_bead_speed + drift_over_bead_speed * static_cast<double>(steps);
    worst = std::max(
        worst, is_swimming ? error * speeds.bead / speeds.swimmer : std::numeric_limits<double>::infinity());
  }
  return worst;
}

}  // namespace beadswim
