#pragma once

#include <concepts>
#include <map>
#include <string>
#include <vector>

#include "beadswim/scene/layout.hpp"

// Comparison of the scenes of a run and of its reference. A difference shows that the two were not made from
// the same layout. Every field of a layout, a swimmer type or a swimmer belongs to a property: a short table
// names the properties, and a field that the table does not contain is a property of its own.

namespace beadswim {

// Numbers and words of a record (core/fields.hpp) with their JSON pointers: "/beads/0/radius". Optionals
// without value and empty lists have the word "none". Marks are ignored, so that every field has a leaf.

/// A number or a word in a record.
struct FieldLeaf {
  std::string pointer;  ///< of the value in the record
  double number = 0;
  std::string word{};  ///< empty for a number
};

/// Appends the leaves of a value whose JSON pointer is `pointer`.
template <class T>
void append_leaves(std::vector<FieldLeaf>& leaves, const std::string& pointer, const T& value) {
  if constexpr (HasFields<const T>) {
    visit_fields([&](const std::string& name, const auto& field,
                     const auto&...) { append_leaves(leaves, pointer + "/" + name, field); },
                 value);
  } else if constexpr (std::is_arithmetic_v<T>) {
    leaves.push_back({.pointer = pointer, .number = static_cast<double>(value)});
  } else if constexpr (std::is_convertible_v<T, std::string>) {
    leaves.push_back({.pointer = pointer, .word = value});
  } else if constexpr (NamedEnum<T>) {
    leaves.push_back({.pointer = pointer, .word = to_text(value)});
  } else if constexpr (is_optional<T>) {
    if (value) return append_leaves(leaves, pointer, *value);
    leaves.push_back({.pointer = pointer, .word = "none"});
  } else if constexpr (requires { value.coeffs(); }) {  // quaternion
    append_leaves(leaves, pointer, Eigen::Vector4d(value.coeffs()));
  } else if constexpr (std::same_as<T, Eigen::Matrix3d>) {
    for (int row = 0; row < 3; ++row)
      append_leaves(leaves, pointer + "/" + std::to_string(row), Vec3(value.row(row)));
  } else if constexpr (requires { typename T::mapped_type; }) {
    for (const auto& [key, element] : value) append_leaves(leaves, pointer + "/" + key, element);
  } else {
    std::size_t index = 0;
    for (const auto& element : value) append_leaves(leaves, pointer + "/" + std::to_string(index++), element);
    if (index == 0) leaves.push_back({.pointer = pointer, .word = "none"});
  }
}

/// Returns the leaves of a value whose JSON pointer is `pointer`.
template <class T>
std::vector<FieldLeaf> leaves_of(const T& value, const std::string& pointer = "") {
  std::vector<FieldLeaf> leaves;
  append_leaves(leaves, pointer, value);
  return leaves;
}

/// Value of a property.
struct PropertyValue {
  std::vector<FieldLeaf> leaves{};  ///< numbers are compared with a relative tolerance
  std::string text = "none";        ///< describes the value in messages
};

/// Values of properties by their names.
using SceneProperties = std::map<std::string, PropertyValue>;

/// A property that differs between two scenes, with the text of both values.
struct SceneDifference {
  std::string name, run, reference;

  bool operator==(const SceneDifference&) const = default;

  BEADSWIM_FIELDS(name, run, reference)
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
