#include "beadswim/theory/prediction.hpp"

namespace beadswim {
namespace {

/// Returns the unit of a setting.
double unit_of(const std::string& setting, const UnitScales& units) {
  if (setting == "period") return units.time;
  if (setting == "amplitude") return units.force();
  if (setting == "towing_drag") return units.damping();
  const bool is_velocity = setting == "numerical_error" ||
                           (setting.starts_with("velocity_") && setting != "velocity_over_unbounded");
  return is_velocity ? units.velocity() : 1;
}

}  // namespace

void to_layout_units(Prediction& prediction, const UnitScales& units) {
  prediction.velocity *= units.velocity();
  if (auto& velocity = prediction.velocity_vector) *velocity *= units.velocity();
  if (auto& angular_velocity = prediction.angular_velocity) *angular_velocity /= units.time;
  for (double& amplitude : prediction.stroke.amplitude) amplitude *= units.length;
  if (auto& power = prediction.power) *power *= units.power();
  if (auto& means = prediction.arm_means)
    for (double& mean : *means) mean *= units.length;
  for (auto& [name, value] : prediction.settings)
    if (double* number = std::get_if<double>(&value)) *number *= unit_of(name, units);
}

}  // namespace beadswim
