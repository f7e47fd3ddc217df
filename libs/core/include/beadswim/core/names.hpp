#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "beadswim/core/error.hpp"

// Tables of the names that the values of an enumeration have in flags and documents. Each enumeration has one
// table, which is defined next to the enumeration:
//
//   template <>
//   inline constexpr auto name_table<Precision> =
//       std::to_array<NamedValue<Precision>>({{Precision::fp64, "double"}, {Precision::fp32, "single"}});
//
// JSON documents (io/json.hpp) and command lines (tools/named_flags.hpp) use this table.

namespace beadswim {

/// Returns the candidate that a misspelt `name` probably stands for, or an empty text if there is none. A
/// candidate qualifies if few insertions, deletions, substitutions and swaps of adjacent letters turn `name`
/// into the candidate or into a part of it (for example "viscosty" into a part of "kinematic_viscosity"). If
/// several candidates qualify, returns the candidate with the fewest such changes.
std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

/// Returns the end of a message about an unknown name: "; did you mean \"NEAREST\"?", or "." if
/// nearest_name() finds no candidate.
std::string format_suggestion(const std::string& name, const std::vector<std::string>& candidates);

/// Returns the message "unknown value \"NAME\"", followed by the nearest allowed name, if there is one, and
/// by all `allowed` names.
std::string format_unknown_name(const std::string& name, const std::vector<std::string>& allowed);

template <typename Enum>
struct NamedValue {
  Enum value;
  std::string_view name;
};

/// All values of an enumeration with their names, in the order in which the help text lists them.
template <typename Enum>
inline constexpr std::array<NamedValue<Enum>, 0> name_table{};

template <typename Enum>
concept NamedEnum = std::is_enum_v<Enum> && name_table<Enum>
.size() > 0;

/// All values of an enumeration, in the order of its table.
template <NamedEnum Enum>
inline constexpr auto all_values = [] {
  std::array<Enum, name_table<Enum>.size()> values{};
  std::ranges::transform(name_table<Enum>, values.begin(), &NamedValue<Enum>::value);
  return values;
}();

template <NamedEnum Enum>
std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const auto& row : name_table<Enum>) names.emplace_back(row.name);
  return names;
}

template <NamedEnum Enum>
std::string to_text(Enum value) {
  const auto row = std::ranges::find(name_table<Enum>, value, &NamedValue<Enum>::value);
  return std::string(row->name);
}

/// Returns the enumeration value with the name `name`, or nullopt if no value has this name.
template <NamedEnum Enum>
std::optional<Enum> value_named(std::string_view name) {
  const auto row = std::ranges::find(name_table<Enum>, name, &NamedValue<Enum>::name);
  return row == name_table<Enum>.end() ? std::nullopt : std::optional(row->value);
}

/// Returns the enumeration value with the name `name`. If no value has this name, throws InputError with a
/// list of all names.
template <NamedEnum Enum>
Enum from_text(const std::string& name) {
  if (const auto value = value_named<Enum>(name)) return *value;
  throw InputError(format_unknown_name(name, all_names<Enum>()));
}

}  // namespace beadswim
