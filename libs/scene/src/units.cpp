#include "beadswim/scene/units.hpp"

#include <algorithm>
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

std::string length_unit(const Units& units) {
  return units.lattice ? "lattice units" : units.length.name;
}

std::string time_unit(const Units& units) {
  return units.lattice ? "lattice units" : units.time.name;
}

std::string velocity_unit(const Units& units) {
  return units.lattice ? "lattice units" : units.length.name + "/" + units.time.name;
}

std::string unit_names(const Units& units) {
  if (units.lattice) return "lattice units";
  return units.length.name + ", " + units.time.name + ", " + units.mass.name;
}

}  // namespace beadswim
