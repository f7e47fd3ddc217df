#include "beadswim/documents/layout_document.hpp"

#include "beadswim/io/document_fault.hpp"
#include "beadswim/io/schema.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/scene/names.hpp"
#include "beadswim/scene/units.hpp"
#include "domain_json.hpp"

namespace beadswim {
namespace {

// --- units

Units::Unit unit_from(const Json& json, Quantity quantity) {
  if (json.is_string()) return *find_known_unit(quantity, json.get<std::string>());
  return {json["name"].get<std::string>(), json["si_factor"].get<double>()};
}

Json json_of(const Units::Unit& unit, Quantity quantity) {
  if (find_known_unit(quantity, unit.name)) return unit.name;
  return {{"name", unit.name}, {"si_factor", unit.si_factor}};
}

Units units_from(const Json& json) {
  if (json.is_string()) return {};
  return {.lattice = false,
          .length = unit_from(json["length"], Quantity::length),
          .time = unit_from(json["time"], Quantity::time),
          .mass = unit_from(json["mass"], Quantity::mass)};
}

Json json_of(const Units& units) {
  if (units.lattice) return "lattice";
  return {{"length", json_of(units.length, Quantity::length)},
          {"time", json_of(units.time, Quantity::time)},
          {"mass", json_of(units.mass, Quantity::mass)}};
}

// --- driving

/// The driving with whatever the object says in place of what was there.
Driving overridden(Driving driving, const Json& json) {
  if (json.contains("amplitude")) {
    driving.amplitude = {json["amplitude"][0].get<double>(), json["amplitude"][1].get<double>()};
  }
  if (json.contains("phase")) driving.phase = json["phase"].get<double>();
  if (json.contains("phase_offset")) driving.phase_offset = json["phase_offset"].get<double>();
  if (json.contains("period")) driving.period = json["period"].get<double>();
  if (json.contains("frame"))
    driving.frame = from_name(frame_names, json["frame"].get<std::string>()).value();
  return driving;
}

Json json_of(const Driving& driving) {
  Json json{{"amplitude", Json::array({driving.amplitude[0], driving.amplitude[1]})},
            {"phase", driving.phase},
            {"period", driving.period},
            {"frame", to_name(frame_names, driving.frame)}};
  if (driving.phase_offset != 0) json["phase_offset"] = driving.phase_offset;
  return json;
}

/// The members of `driving` that differ from the type's.
Json difference(const Driving& driving, const Driving& of_type) {
  Json json = json_of(driving);
  const Json ordinary = json_of(of_type);
  for (const auto& [key, value] : ordinary.items()) {
    if (json.contains(key) && json[key] == value) json.erase(key);
  }
  if (driving.phase_offset == 0 && of_type.phase_offset != 0) json["phase_offset"] = 0.0;
  return json;
}

// --- types

SwimmerType type_from(const Json& json) {
  SwimmerType type;
  for (std::size_t i = 0; i < type.beads.size(); ++i) {
    const Json& bead = json["beads"][i];
    type.beads[i] = {bead["radius"].get<double>(), bead["density"].get<double>()};
  }
  for (std::size_t i = 0; i < type.springs.size(); ++i) {
    const Json& spring = json["springs"][i];
    type.springs[i] = {spring["stiffness"].get<double>(), spring["rest_length"].get<double>(),
                       spring["damping"].get<double>()};
  }
  type.angular_stiffness = json["angular_stiffness"].get<double>();
  type.driving = overridden({}, json["driving"]);
  return type;
}

Json json_of(const SwimmerType& type) {
  Json beads = Json::array();
  for (const Bead& bead : type.beads) beads.push_back({{"radius", bead.radius}, {"density", bead.density}});
  Json springs = Json::array();
  for (const Spring& spring : type.springs) {
    springs.push_back(
        {{"stiffness", spring.stiffness}, {"rest_length", spring.rest_length}, {"damping", spring.damping}});
  }
  return {{"beads", beads},
          {"springs", springs},
          {"angular_stiffness", type.angular_stiffness},
          {"driving", json_of(type.driving)}};
}

// --- swimmers

Swimmer swimmer_from(const Json& json, const std::map<std::string, SwimmerType>& types) {
  Swimmer swimmer{.id = json["id"].get<int>(),
                  .type = json["type"].get<std::string>(),
                  .position = vec3_from_json(json["position"]),
                  .axis = vec3_from_json(json["axis"])};
  const auto type = types.find(swimmer.type);  // an unknown one is a fault, which check_layout finds
  if (json.contains("driving") && type != types.end()) {
    swimmer.driving = overridden(type->second.driving, json["driving"]);
  }
  return swimmer;
}

Json json_of(const Swimmer& swimmer, const SwimmerType& type) {
  Json json{{"id", swimmer.id},
            {"type", swimmer.type},
            {"position", vec3_to_json(swimmer.position)},
            {"axis", vec3_to_json(swimmer.axis)}};
  if (swimmer.driving) {
    Json own = difference(*swimmer.driving, type.driving);
    if (!own.empty()) json["driving"] = std::move(own);
  }
  return json;
}

Layout layout_from(const Json& json) {
  Layout layout;
  layout.units = units_from(json["units"]);
  layout.fluid = {json["fluid"]["density"].get<double>(), json["fluid"]["kinematic_viscosity"].get<double>()};
  layout.domain = domain_from_json(json["domain"]);
  for (const auto& [name, type] : json["types"].items()) layout.types[name] = type_from(type);
  for (const Json& swimmer : json["swimmers"]) layout.swimmers.push_back(swimmer_from(swimmer, layout.types));
  if (json.contains("resolution")) {
    const Json& hint = json["resolution"];
    layout.resolution = {hint["cells_per_radius"].get<double>(), hint["relaxation_time"].get<double>()};
  }
  return layout;
}

}  // namespace

LayoutDocument layout_from_json(const Json& json, const std::string& source) {
  validate_json(json, "layout", source);

  LayoutDocument document{layout_from(json), json.value("provenance", Json::array())};
  normalise_axes(document.layout);
  std::vector<DocumentFault> faults;
  for (const LayoutFault& fault : check_layout(document.layout))
    faults.push_back({fault.place, fault.message});
  refuse_faulty(source, faults);
  return document;
}

LayoutDocument read_layout(const std::string& path) {
  const std::string source = path == "-" ? "standard input" : path;
  return layout_from_json(parse_json(read_text(path), source), source);
}

Json layout_to_json(const LayoutDocument& document) {
  const Layout& layout = document.layout;
  Json json{{"schema", "beadswim/layout/1"},
            {"units", json_of(layout.units)},
            {"fluid",
             {{"density", layout.fluid.density}, {"kinematic_viscosity", layout.fluid.kinematic_viscosity}}},
            {"domain", domain_to_json(layout.domain)},
            {"types", Json::object()},
            {"swimmers", Json::array()}};
  for (const auto& [name, type] : layout.types) json["types"][name] = json_of(type);
  for (const Swimmer& swimmer : layout.swimmers) {
    json["swimmers"].push_back(json_of(swimmer, layout.types.at(swimmer.type)));
  }
  if (layout.resolution) {
    json["resolution"] = {{"cells_per_radius", layout.resolution->cells_per_radius},
                          {"relaxation_time", layout.resolution->relaxation_time}};
  }
  json["provenance"] = document.provenance;
  return json;
}

}  // namespace beadswim
