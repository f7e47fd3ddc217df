#include "units_json.hpp"

namespace beadswim {
namespace {

Json unit_to_json(const Units::Unit& unit) {
  return {{"name", unit.name}, {"si_factor", unit.si_factor}};
}

Units::Unit unit_from_json(const Json& json) {
  return {json.at("name").get<std::string>(), json.at("si_factor").get<double>()};
}

}  // namespace

Json units_to_json(const Units& units) {
  if (units.lattice) return "lattice";
  return {{"length", unit_to_json(units.length)},
          {"time", unit_to_json(units.time)},
          {"mass", unit_to_json(units.mass)}};
}

Units units_from_json(const Json& json) {
  if (json.is_string()) return {};
  return {.lattice = false,
          .length = unit_from_json(json.at("length")),
          .time = unit_from_json(json.at("time")),
          .mass = unit_from_json(json.at("mass"))};
}

}  // namespace beadswim
