#include "beadswim/run/velocity_roundoff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/lattice/trt.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"

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

/// Returns the speeds of a swimmer of this type; of three beads, with the driving along their axis. The speed
/// of the swimmer includes that of its ends by rotation.
Speeds predicted_speeds(const SwimmerType& type, double viscosity) {
  const ShapedSwimmer shape{type, Eigen::Matrix3d::Identity(), viscosity};
  const double bead = first_order_motion(shape, rotne_prager_tensor).largest_speed();
  if (const std::optional<CollinearSwimmer> line = collinear_swimmer(type, viscosity))
    return {bead, std::abs(second_order_motion(*line, rest_mobility(*line, rotne_prager)).velocity)};
  const ShapeMotion motion = second_order_motion(shape, rotne_prager_tensor);
  const double reach = motion.mean_shape.colwise().norm().maxCoeff();
  return {bead, motion.velocity_vector.norm() + motion.angular_velocity.norm() * reach};
}

}  // namespace

double velocity_roundoff(const CoupledScene& scene, long steps_per_period, long steps) {
  double worst = 0;
  for (const SwimmerType& type : scene.types) {
    Speeds speeds{};
    const std::string unknown =
        reason_against([&] { speeds = predicted_speeds(type, lattice_viscosity(scene.relaxation_time)); });
    if (!unknown.empty()) continue;
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
