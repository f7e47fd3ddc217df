#include "variable_label.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "beadswim/core/joined.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {
namespace {

namespace exponents {
constexpr UnitExponents none{}, angle{.is_angle = true}, length{.length = 1}, time{.time = 1},
    velocity{.length = 1, .time = -1}, force{.mass = 1, .length = 1, .time = -2},
    density{.mass = 1, .length = -3}, stiffness{.mass = 1, .time = -2}, damping{.mass = 1, .time = -1},
    energy{.mass = 1, .length = 2, .time = -2}, viscosity{.length = 2, .time = -1}, rate{.time = -1},
    body_force{.mass = 1, .length = -2, .time = -2};
}  // namespace exponents

struct Variable {
  std::string_view key;  ///< last key of a pointer, or name of a flag
  UnitExponents unit;
  std::string_view label{};  ///< if it is not the key with spaces for underscores
};

constexpr auto known_variables = std::to_array<Variable>({
    {"period", exponents::time},
    {"radius", exponents::length},
    {"arm", exponents::length},
    {"rest_length", exponents::length},
    {"position", exponents::length},
    {"at", exponents::length, "place"},
    {"lengths", exponents::length, "box length"},
    {"core-gap", exponents::length},
    {"stiffness", exponents::stiffness},
    {"damping", exponents::damping},
    {"angular-stiffness", exponents::energy},
    {"angular_stiffness", exponents::energy},
    {"density", exponents::density},
    {"bead-density", exponents::density},
    {"amplitude", exponents::force},
    {"constant", exponents::force, "constant force"},
    {"phase", exponents::angle},
    {"phase_offset", exponents::angle},
    {"rest", exponents::angle, "rest angle"},
    {"rotate", exponents::angle, "rotation about"},
    {"thermal-energy", exponents::energy, "thermal energy kT"},
    {"thermal_energy", exponents::energy, "thermal energy kT"},
    {"viscosity", exponents::viscosity},
    {"kinematic_viscosity", exponents::viscosity},
    {"velocity", exponents::velocity, "flow velocity"},
    {"lower_velocity", exponents::velocity},
    {"upper_velocity", exponents::velocity},
    {"velocity_gradient", exponents::rate},
    {"body_force", exponents::body_force},
    {"multiple", exponents::none},
    {"seed", exponents::none},
    {"cells_per_radius", exponents::none},
    {"relaxation_time", exponents::none},
});

bool is_index(const std::string& key) {
  constexpr std::size_t max_digits = 9;  // of an int
  return !key.empty() && key.size() <= max_digits &&
         std::ranges::all_of(key, [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns the letters of the components to which the keys after a variable lead, for example "xz".
std::string component_letters(const std::string& key, const std::vector<std::string>& keys) {
  const std::string_view letters = key == "amplitude" ? "AB" : "xyz";
  std::string text;
  for (const std::string& each : keys)
    text += is_index(each) && each.size() == 1 && each[0] - '0' < std::ssize(letters)
                ? letters.substr(each[0] - '0', 1)
                : each;
  return text;
}

/// Returns which parts of the layout the keys before a variable name: ", bead 2", ", /swimmers/3".
std::string parts_of_layout(const std::vector<std::string>& keys) {
  constexpr std::array lists{"beads", "bonds", "springs", "angles", "forces", "harmonics"};
  std::string text;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    if (!is_index(keys[i + 1])) continue;
    if (keys[i] == "swimmers") text += fmt::format(", /swimmers/{}", keys[i + 1]);
    if (std::ranges::find(lists, keys[i]) == lists.end()) continue;
    text += fmt::format(", {} {}", keys[i].substr(0, keys[i].size() - 1), std::stoi(keys[i + 1]) + 1);
  }
  return text;
}

/// Returns the unit of the variable with these keys before it: harmonics of bonds and angles, and stiffnesses
/// of angles, have others than those of forces and bonds.
UnitExponents unit_in(const Variable& variable, const std::vector<std::string>& keys) {
  const auto is_in = [&](const char* key) { return std::ranges::find(keys, key) != keys.end(); };
  if (variable.key == "stiffness" && is_in("angles")) return exponents::energy;
  if (variable.key != "amplitude" && variable.key != "constant") return variable.unit;
  return is_in("angles") ? exponents::angle : is_in("rest_length") ? exponents::length : variable.unit;
}

}  // namespace

AxisLabel variable_label(const std::string& name, const Units& units) {
  const bool is_pointer = name.starts_with('/');
  const std::vector<std::string> keys = split_at('/', name);
  for (std::size_t i = keys.size(); i-- > 0;) {
    const auto found = std::ranges::find(known_variables, keys[i], &Variable::key);
    if (found == known_variables.end()) {
      if (is_index(keys[i]) || keys[i].size() == 1) continue;  // a component
      break;
    }
    const std::vector<std::string> before(keys.begin(), keys.begin() + i),
        after(keys.begin() + i + 1, keys.end());
    const std::string unit = unit_text(unit_in(*found, before), units);
    if (!is_pointer) return {name, unit};
    std::string label(found->label.empty() ? found->key : found->label);
    std::ranges::replace(label, '_', ' ');
    if (!after.empty()) label += " " + component_letters(keys[i], after);
    return {label + parts_of_layout(before), unit};
  }
  return {name, ""};
}

}  // namespace beadswim
