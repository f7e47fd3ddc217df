#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "beadswim/scene/layout.hpp"

// How enumerators are called in documents and at the command line.

namespace beadswim {

template <typename Enum, std::size_t n>
using EnumNames = std::array<std::pair<Enum, std::string_view>, n>;

inline constexpr EnumNames<DrivingFrame, 3> frame_names{
    {{DrivingFrame::lab, "lab"}, {DrivingFrame::initial_axis, "initial-axis"}, {DrivingFrame::body, "body"}}};
inline constexpr EnumNames<Boundary, 3> boundary_names{
    {{Boundary::periodic, "periodic"}, {Boundary::free_slip, "free-slip"}, {Boundary::no_slip, "no-slip"}}};

/// The enumerator of that name, if there is one.
template <typename Enum, std::size_t n>
std::optional<Enum> from_name(const EnumNames<Enum, n>& names, std::string_view name) {
  for (const auto& [value, known] : names) {
    if (name == known) return value;
  }
  return std::nullopt;
}

/// The name of an enumerator; the table has all of them.
template <typename Enum, std::size_t n>
std::string to_name(const EnumNames<Enum, n>& names, Enum value) {
  for (const auto& [known, name] : names) {
    if (value == known) return std::string(name);
  }
  return {};
}

template <typename Enum, std::size_t n>
std::vector<std::string> all_names(const EnumNames<Enum, n>& names) {
  std::vector<std::string> all;
  for (const auto& [value, name] : names) all.emplace_back(name);
  return all;
}

}  // namespace beadswim
