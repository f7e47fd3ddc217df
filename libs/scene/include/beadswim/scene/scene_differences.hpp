#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/scene/layout.hpp"

// Comparison of the scenes of a run and of its reference. A difference shows that the two were not made from
// the same layout.

namespace beadswim {

/// Property of a scene. The properties from period to angular_stiffness belong to each swimmer.
enum class SceneProperty {
  period,
  amplitude,
  phase,  ///< driving phase alpha
  frame,
  radius,
  bead_density,
  arm,  ///< rest lengths
  stiffness,
  damping,
  angular_stiffness,
  fluid,  ///< density and viscosity
  domain,
  flow,
  body_force,
  swimmers,  ///< number and ids of the swimmers
  placing,   ///< positions, axes and phase offsets
};

template <>
inline constexpr auto name_table<SceneProperty> =
    std::to_array<NamedValue<SceneProperty>>({{SceneProperty::period, "period"},
                                              {SceneProperty::amplitude, "amplitude"},
                                              {SceneProperty::phase, "phase"},
                                              {SceneProperty::frame, "frame"},
                                              {SceneProperty::radius, "radius"},
                                              {SceneProperty::bead_density, "bead_density"},
                                              {SceneProperty::arm, "arm"},
                                              {SceneProperty::stiffness, "stiffness"},
                                              {SceneProperty::damping, "damping"},
                                              {SceneProperty::angular_stiffness, "angular_stiffness"},
                                              {SceneProperty::fluid, "fluid"},
                                              {SceneProperty::domain, "domain"},
                                              {SceneProperty::flow, "flow"},
                                              {SceneProperty::body_force, "body_force"},
                                              {SceneProperty::swimmers, "swimmers"},
                                              {SceneProperty::placing, "placing"}});

/// Value of a property.
struct PropertyValue {
  std::vector<double> numbers;  ///< compared with a relative tolerance
  std::string text;             ///< describes the value in messages
};

using SceneProperties = std::map<SceneProperty, PropertyValue>;

/// A property that differs between two scenes, with the text of both values.
struct SceneDifference {
  SceneProperty property{};
  std::string run, reference;

  bool operator==(const SceneDifference&) const = default;

  static void visit_fields(auto&& visit, auto& difference) {
    visit("name", difference.property);
    visit("run", difference.run);
    visit("reference", difference.reference);
  }
};

/// Return the values of single properties.
PropertyValue numbers_value(const std::vector<double>& numbers);
PropertyValue domain_value(const Domain& domain);
PropertyValue flow_value(const BackgroundFlow& flow);
PropertyValue body_force_value(const Vec3& force);
PropertyValue swimmers_value(std::vector<int> ids);

/// Returns the fluid, the domain and the ids of the swimmers.
SceneProperties common_properties(const Layout& layout);

/// Returns the properties of a swimmer, from period to angular stiffness.
SceneProperties swimmer_properties(const SwimmerType& type);

/// Adds the properties that run and reference both contain, but with different values. Leaves out properties
/// that `differences` contains already. `prefix`: text before both values.
void add_differences(std::vector<SceneDifference>& differences, const SceneProperties& run,
                     const SceneProperties& reference, const std::string& prefix = "");

/// Returns the differences between two scenes in the same units, in the order of SceneProperty, at most one
/// per property. Swimmers are compared with the swimmer of the same id; the difference states the first
/// swimmer that differs. A common translation of all swimmers is no difference along axes on which one of the
/// scenes has no walls. On periodic axes, positions are compared modulo the box length.
std::vector<SceneDifference> scene_differences(const Layout& run, const Layout& reference);

}  // namespace beadswim
