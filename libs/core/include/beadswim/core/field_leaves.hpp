#pragma once

#include <concepts>
#include <string>
#include <type_traits>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/core/vec3.hpp"

// Numbers and words of a record (core/fields.hpp) with their JSON pointers: "/beads/0/radius". Optionals
// without value and empty lists have the word "none". Marks are ignored, so that every field has a leaf.

namespace beadswim {

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

}  // namespace beadswim
