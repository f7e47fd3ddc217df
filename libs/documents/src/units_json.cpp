#include "units_json.hpp"

namespace beadswim {

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
  units = {.lattice = false, .length = json.at("length"), .time = json.at("time"), .mass = json.at("mass")};
}

}  // namespace beadswim
