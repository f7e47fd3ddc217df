#pragma once

#include <map>
#include <string>
#include <vector>

#include "beadswim/core/field_leaves.hpp"
#include "beadswim/scene/layout.hpp"

// Comparison of the scenes of a run and of its reference. A difference shows that the two were not made from
// the same layout. Every field of a layout, a swimmer type or a swimmer belongs to a property: a short table
// names the properties, and a field that the table does not contain is a property of its own.

namespace beadswim {

/// Value of a property.
struct PropertyValue {
  std::vector<FieldLeaf> leaves{};  ///< numbers are compared with a relative tolerance
  std::string text = "none";        ///< describes the value in messages
};

/// Values of properties by their names.
using SceneProperties = std::map<std::string, PropertyValue>;

/// A property that differs between two scenes, with the text of both values.
struct SceneDifference {
  std::string property;
  std::string run, reference;

  bool operator==(const SceneDifference&) const = default;

  static void visit_fields(auto&& visit, auto& difference) {
    visit("name", difference.property);
    visit("run", difference.run);
    visit("reference", difference.reference);
  }
};

/// Returns the names of all properties: those from "period" to "angular_stiffness" belong to each swimmer,
/// the others to the scene.
const std::vector<std::string>& scene_property_names();

/// Returns the properties that leaves of a layout, a swimmer type, a ThreeBeadSwimmer or a swimmer belong to.
SceneProperties properties_of(std::vector<FieldLeaf> leaves);

/// Returns the properties of the fluid, the domain and the flow, and the ids of the swimmers.
SceneProperties common_properties(const Layout& layout);

/// Returns the properties of a swimmer of this type.
SceneProperties swimmer_properties(const SwimmerType& type);

/// Returns the value of the property "swimmers".
PropertyValue swimmers_value(std::vector<int> ids);

/// Adds the properties that run and reference both contain, but with different values. Leaves out properties
/// that `differences` contains already. `prefix`: text before both values.
void add_differences(std::vector<SceneDifference>& differences, const SceneProperties& run,
                     const SceneProperties& reference, const std::string& prefix = "");

/// Returns the differences between two scenes in the same units, in the order of scene_property_names(), at
/// most one per property. Swimmers are compared with the swimmer of the same id; the difference states the
/// first swimmer that differs. A common translation of all swimmers is no difference along axes on which one
/// of the scenes has no walls. On periodic axes, positions are compared modulo the box length.
std::vector<SceneDifference> scene_differences(const Layout& run, const Layout& reference);

}  // namespace beadswim
