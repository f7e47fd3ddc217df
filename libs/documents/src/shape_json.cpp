#include "shape_json.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "beadswim/io/fields_json.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

/// Returns the elements of a list that may be missing.
const Json& list(const Json& json, const char* key) {
  static const Json none = Json::array();
  return json.contains(key) ? json[key] : none;
}

template <std::size_t size>
std::array<int, size> numbers_from_1(const Json& json) {
  std::array<int, size> numbers{};
  for (std::size_t n = 0; n < size; ++n) numbers[n] = json.at(n).get<int>() - 1;
  return numbers;
}

template <std::size_t size>
Json numbers_from_1(const std::array<int, size>& numbers) {
  Json json = Json::array();
  for (const int number : numbers) json.push_back(number + 1);
  return json;
}

std::vector<Harmonic> harmonics_from(const Json& json) {
  std::vector<Harmonic> harmonics;
  for (const Json& each : json)
    harmonics.push_back({.amplitude = each["amplitude"].get<double>(),
                         .phase = each.value("phase", 0.0),
                         .multiple = each.value("multiple", 1)});
  return harmonics;
}

Json json_of(const std::vector<Harmonic>& harmonics) {
  Json json = Json::array();
  for (const Harmonic& harmonic : harmonics) {
    Json& each = json.emplace_back(Json{{"amplitude", harmonic.amplitude}});
    if (harmonic.phase != 0) each["phase"] = harmonic.phase;
    if (harmonic.multiple != 1) each["multiple"] = harmonic.multiple;
  }
  return json;
}

/// Returns the unit vector along a vector of any finite length. Zero and unit vectors stay as they are.
Vec3 unit_vector(const Vec3& vector) {
  constexpr double roundoff = 1e-15;  // of the norm of a unit vector
  const double largest = vector.cwiseAbs().maxCoeff();
  if (largest == 0 || std::abs(vector.norm() - 1) <= roundoff) return vector;
  return (vector / largest).normalized();  // the squares of the vector itself could underflow or overflow
}

ForceDrive force_from(const Json& json) {
  return {.bead = json["bead"].get<int>() - 1,
          .direction = unit_vector(json["direction"].get<Vec3>()),
          .constant = json.value("constant", 0.0),
          .harmonics = harmonics_from(list(json, "harmonics"))};
}

Json json_of(const ForceDrive& drive) {
  Json json{{"bead", drive.bead + 1}, {"direction", drive.direction}};
  if (drive.constant != 0) json["constant"] = drive.constant;
  if (!drive.harmonics.empty()) json["harmonics"] = json_of(drive.harmonics);
  return json;
}

/// A drive with tension and rest length becomes two.
void add_bond_drives(std::vector<BondDrive>& drives, const Json& json) {
  for (const auto quantity : {BondQuantity::tension, BondQuantity::rest_length}) {
    const char* key = quantity == BondQuantity::tension ? "tension" : "rest_length";
    if (json.contains(key))
      drives.push_back({.bond = json["bond"].get<int>() - 1,
                        .quantity = quantity,
                        .harmonics = harmonics_from(json[key])});
  }
}

Json json_of(const BondDrive& drive) {
  const char* key = drive.quantity == BondQuantity::tension ? "tension" : "rest_length";
  return {{"bond", drive.bond + 1}, {key, json_of(drive.harmonics)}};
}

Json json_of(const AngleDrive& drive) {
  return {{"angle", drive.angle + 1}, {"rest", json_of(drive.harmonics)}};
}

template <class Drive>
Json list_of(const std::vector<Drive>& drives) {
  Json json = Json::array();
  for (const Drive& drive : drives) json.push_back(json_of(drive));
  return json;
}

Json json_of(const Driving& driving) {
  Json json{{"period", driving.period}};
  if (driving.phase_offset != 0) json["phase_offset"] = driving.phase_offset;
  json["frame"] = driving.frame;
  if (!driving.forces.empty()) json["forces"] = list_of(driving.forces);
  if (!driving.bonds.empty()) json["bonds"] = list_of(driving.bonds);
  if (!driving.angles.empty()) json["angles"] = list_of(driving.angles);
  if (driving.net_force_allowed) json["net_force"] = "allowed";
  return json;
}

bool are_beads(const SwimmerType& type, const auto& numbers) {
  return std::ranges::all_of(numbers, [&](int b) { return b >= 0 && b < std::ssize(type.beads); });
}

Bond bond_from(const Json& json, const SwimmerType& type) {
  Bond bond;
  bond.beads = numbers_from_1<2>(json["beads"]);
  bond.stiffness = json["stiffness"].get<double>();
  bond.damping = json.value("damping", 0.0);
  if (json.contains("rest_length")) {
    bond.rest_length = json["rest_length"].get<double>();
  } else if (are_beads(type, bond.beads)) {
    bond.rest_length = (type.beads[bond.beads[1]].at - type.beads[bond.beads[0]].at).norm();
  }
  return bond;
}

Angle angle_from(const Json& json, const SwimmerType& type) {
  Angle angle{.beads = numbers_from_1<3>(json["beads"]), .stiffness = json["stiffness"].get<double>()};
  if (json.contains("rest")) {
    angle.rest = json["rest"].get<double>();
  } else if (are_beads(type, angle.beads)) {
    angle.rest = angle_at_rest(type, angle);
  }
  return angle;
}

void add_drive_faults(const Json& driving, const std::string& place, std::vector<DocumentFault>& faults) {
  const Json& drives = list(driving, "bonds");
  for (std::size_t n = 0; n < drives.size(); ++n) {
    if (drives[n].contains("tension") != drives[n].contains("rest_length")) continue;
    faults.push_back(
        {fmt::format("{}/bonds/{}", place, n),
         "a drive of a bond needs exactly one of the keys \"tension\" and \"rest_length\"; write "
         "two drives to change both"});
  }
}

}  // namespace

std::vector<DocumentFault> shape_faults(const Json& layout) {
  std::vector<DocumentFault> faults;
  for (const auto& [name, type] : layout["types"].items())
    add_drive_faults(type["driving"], "/types/" + name + "/driving", faults);
  for (std::size_t s = 0; s < layout["swimmers"].size(); ++s) {
    const Json& swimmer = layout["swimmers"][s];
    const std::string place = fmt::format("/swimmers/{}", s);
    if (swimmer.contains("driving")) add_drive_faults(swimmer["driving"], place + "/driving", faults);
    if (swimmer.contains("axis") && swimmer.contains("orientation"))
      faults.push_back(
          {place + "/orientation", "the swimmer has an axis and an orientation; leave one of them out"});
  }
  return faults;
}

Driving override_shape_driving(Driving driving, const Json& json) {
  if (json.contains("period")) json["period"].get_to(driving.period);
  if (json.contains("phase_offset")) json["phase_offset"].get_to(driving.phase_offset);
  if (json.contains("frame")) json["frame"].get_to(driving.frame);
  if (json.contains("net_force")) driving.net_force_allowed = json["net_force"] == "allowed";
  if (json.contains("forces")) {
    driving.forces.clear();
    for (const Json& drive : json["forces"]) driving.forces.push_back(force_from(drive));
  }
  if (json.contains("bonds")) {
    driving.bonds.clear();
    for (const Json& drive : json["bonds"]) add_bond_drives(driving.bonds, drive);
  }
  if (json.contains("angles")) {
    driving.angles.clear();
    for (const Json& drive : json["angles"])
      driving.angles.push_back(
          {.angle = drive["angle"].get<int>() - 1, .harmonics = harmonics_from(drive["rest"])});
  }
  return driving;
}

Json shape_driving_difference(const Driving& driving, const Driving& of_type) {
  Json json = json_of(driving);
  const Json ordinary = json_of(of_type);
  for (const auto& [key, value] : ordinary.items()) {
    if (!json.contains(key)) {  // states what the type's driving has and this one does not
      json[key] = key == "phase_offset" ? Json(0.0) : key == "net_force" ? Json("zero") : Json::array();
    } else if (json[key] == value) {
      json.erase(key);
    }
  }
  return json;
}

SwimmerType shape_from_json(const Json& json) {
  SwimmerType type;
  for (const Json& bead : json["beads"])
    type.beads.push_back({{.radius = bead["radius"].get<double>(), .density = bead["density"].get<double>()},
                          bead["at"].get<Vec3>()});
  for (const Json& bond : list(json, "bonds")) type.bonds.push_back(bond_from(bond, type));
  for (const Json& angle : list(json, "angles")) type.angles.push_back(angle_from(angle, type));
  type.driving = override_shape_driving({}, json["driving"]);
  return type;
}

Json shape_to_json(const SwimmerType& type) {
  Json json{{"beads", Json::array()}};
  for (const BeadAtRest& bead : type.beads)
    json["beads"].push_back({{"radius", bead.radius}, {"density", bead.density}, {"at", bead.at}});
  if (!type.bonds.empty()) {
    json["bonds"] = Json::array();
    for (const Bond& bond : type.bonds)
      json["bonds"].push_back({{"beads", numbers_from_1(bond.beads)},
                               {"stiffness", bond.stiffness},
                               {"rest_length", bond.rest_length},
                               {"damping", bond.damping}});
  }
  if (!type.angles.empty()) {
    json["angles"] = Json::array();
    for (const Angle& angle : type.angles)
      json["angles"].push_back(
          {{"beads", numbers_from_1(angle.beads)}, {"stiffness", angle.stiffness}, {"rest", angle.rest}});
  }
  json["driving"] = json_of(type.driving);
  return json;
}

}  // namespace beadswim
