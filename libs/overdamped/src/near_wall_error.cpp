#include "beadswim/overdamped/overdamped_setup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "beadswim/mobility/mobility.hpp"
#include "beadswim/mobility/near_field.hpp"
#include "beadswim/mobility/wall_map.hpp"

namespace beadswim {
namespace {

/// Returns the relative error of the mobility of one sphere across the wall, by the exact solution.
double error_across_wall(double height, MobilityModel model, int moment_order) {
  constexpr double lowest = 1.0001;
  const Vec3 place = std::max(height, lowest) * Vec3::UnitZ(), force = Vec3::UnitZ();
  const MobilityScene scene{.model = model,
                            .viscosity = 1 / (6 * std::numbers::pi),
                            .domain = {.box = {}, .half_space = HalfSpace{}},
                            .radii = {1},
                            .moment_order = moment_order};
  Vec3 velocity;
  const Communicator self(MPI_COMM_SELF);
  Mobility(scene, {&place, 1}, self).apply({&force, 1}, {&velocity, 1});
  return std::abs(velocity.z() * drag_towards_wall(place.z()) - 1);
}

}  // namespace

// The error of one sphere, or that of several if it is larger: c H^-(4 + 2 n) for moments up to order n, with
// c as found near the wall (docs/method/half-space.md); H^-3 for point forces. rpy+near is exact across the
// wall. Along it, one sphere moves as by moments of order 1 where its stresslet has the weight 1, and as by
// rpy, with an error of 45/256 H^-4, where it has the weight 0.
double error_near_wall(double height, MobilityModel model, const MobilitySettings& settings) {
  if (!std::isfinite(height)) return 0;
  const int order = has_moment_order(model) ? settings.multipole_order : 0;
  const double across = error_across_wall(height, model, order);
  if (!has_finite_radii(model)) return std::max(across, std::pow(height, -3));
  constexpr std::array coefficients{1.1, 0.7, 0.33};
  if (model == MobilityModel::rpy_near)
    return std::max(coefficients[1] * std::pow(height, -6),
                    0.22 * std::pow(height, -4) * std::pow(1 - pair_weight(height), 2));
  return std::max(across, coefficients[order] * std::pow(height, -4 - 2 * order));
}

}  // namespace beadswim
