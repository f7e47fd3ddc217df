#include "beadswim/scene/units.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

namespace beadswim {

const std::vector<Units::Unit>& known_units(Quantity quantity) {
  static const std::map<Quantity, std::vector<Units::Unit>> units{
      {Quantity::length, {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"nm", 1e-9}}},
      {Quantity::time, {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}},
      {Quantity::mass,
       {{"kg", 1}, {"g", 1e-3}, {"mg", 1e-6}, {"ug", 1e-9}, {"ng", 1e-12}, {"pg", 1e-15}, {"fg", 1e-18}}}};
  return units.at(quantity);
}

const Units::Unit* find_known_unit(Quantity quantity, const std::string& name) {
  const auto& units = known_units(quantity);
  const auto unit = std::ranges::find(units, name, &Units::Unit::name);
  return unit == units.end() ? nullptr : &*unit;
}

std::string unit_text(const UnitExponents& unit, const Units& units) {
  const bool has_unit = unit.mass != 0 || unit.length != 0 || unit.time != 0;
  if (units.lattice && has_unit) return "lattice units";
  std::string above = unit.is_angle ? "rad" : "", below;
  const auto multiply = [&](const std::string& name, int exponent) {
    constexpr std::array powers{"", "", "²", "³"};
    std::string& side = exponent > 0 ? above : below;
    if (exponent != 0) side += (side.empty() ? "" : " ") + name + powers[std::abs(exponent)];
  };
  multiply(units.mass.name, unit.mass);
  multiply(units.length.name, unit.length);
  multiply(units.time.name, unit.time);
  if (below.find(' ') != std::string::npos) below = "(" + below + ")";
  return below.empty() ? above : (above.empty() ? "1" : above) + "/" + below;
}

std::string length_unit(const Units& units) {
  return unit_text({.length = 1}, units);
}

std::string velocity_unit(const Units& units) {
  return unit_text({.length = 1, .time = -1}, units);
}

std::string unit_names(const Units& units) {
  if (units.lattice) return "lattice units";
  return units.length.name + ", " + units.time.name + ", " + units.mass.name;
}

}  // namespace beadswim
