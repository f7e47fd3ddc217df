#include "layout_json.hpp"

#include <algorithm>

#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

Units::Unit unit_from(const Json& json, Quantity quantity) {
  return json.is_string() ? *find_known_unit(quantity, json.get<std::string>()) : json.get<Units::Unit>();
}

bool are_beads(const SwimmerType& type, const auto& numbers) {
  return std::ranges::all_of(numbers, [&](int b) { return b >= 0 && b < std::ssize(type.beads); });
}

}  // namespace

void to_json(Json& json, const Units& units) {
  if (units.lattice) {
    json = "lattice";
  } else {
    json = {{"length", units.length}, {"time", units.time}, {"mass", units.mass}};
  }
}

void from_json(const Json& json, Units& units) {
  units = {};
  if (json.is_string()) return;
  units = {.lattice = false,
           .length = unit_from(json["length"], Quantity::length),
           .time = unit_from(json["time"], Quantity::time),
           .mass = unit_from(json["mass"], Quantity::mass)};
}

void to_json(Json& json, const BondDrive& drive) {
  json = {{"bond", drive.bond + 1}, {to_text(drive.quantity), drive.harmonics}};
}

void from_json(const Json& json, BondDrive& drive) {
  drive.bond = json["bond"].get<int>() - 1;
  for (const auto& [quantity, key] : name_table<BondQuantity>) {
    if (!json.contains(key)) continue;
    drive.quantity = quantity;
    json[std::string(key)].get_to(drive.harmonics);
  }
}

void from_json(const Json& json, SwimmerType& type) {
  if (json.contains("springs")) {
    type = swimmer_type(json.get<ThreeBeadSwimmer>());
    return;
  }
  from_json<SwimmerType>(json, type);
  for (std::size_t k = 0; k < type.bonds.size(); ++k) {
    Bond& bond = type.bonds[k];
    if (!json["bonds"][k].contains("rest_length") && are_beads(type, bond.beads))
      bond.rest_length = (type.beads[bond.beads[1]].at - type.beads[bond.beads[0]].at).norm();
  }
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    Angle& angle = type.angles[k];
    if (!json["angles"][k].contains("rest") && are_beads(type, angle.beads))
      angle.rest = angle_at_rest(type, angle);
  }
}

}  // namespace beadswim
