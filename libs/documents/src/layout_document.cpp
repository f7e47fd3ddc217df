#include "beadswim/documents/layout_document.hpp"

#include "absent_features.hpp"
#include "beadswim/io/box_json.hpp"
#include "beadswim/io/document_fault.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/io/schema.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "shape_json.hpp"

namespace beadswim {
namespace {

constexpr const char *schema_one = "beadswim/layout/1", *schema_two = "beadswim/layout/2";

// --- units

Units::Unit unit_from(const Json& json, Quantity quantity) {
  if (json.is_string()) return *find_known_unit(quantity, json.get<std::string>());
  return json.get<Units::Unit>();
}

Json json_of(const Units::Unit& unit, Quantity quantity) {
  if (find_known_unit(quantity, unit.name)) return unit.name;
  return unit;
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

/// Returns a copy of `driving` in which the members that `json` contains are replaced.
ThreeBeadDriving override_driving(ThreeBeadDriving driving, const Json& json) {
  visit_fields(
      [&](const char* name, auto& field, auto...) {
        if (json.contains(name)) json[name].get_to(field);
      },
      driving);
  return driving;
}

/// Returns the members of a swimmer's driving that differ from `of_type`, the driving of the swimmer's type.
Json difference(const ThreeBeadDriving& driving, const ThreeBeadDriving& of_type) {
  Json json = driving;
  const Json ordinary = of_type;
  for (const auto& [key, value] : ordinary.items()) {
    if (json.contains(key) && json[key] == value) json.erase(key);
  }
  if (driving.phase_offset == 0 && of_type.phase_offset != 0) json["phase_offset"] = 0.0;
  return json;
}

// --- versions

/// Version 1 of layouts describes the paper's three-bead swimmers, version 2 swimmers of any shape.
enum class Version { one, two };

/// Returns the version with which a layout is written: 1 if it can express the layout.
Version version_of(const Layout& layout) {
  const bool one =
      std::ranges::all_of(layout.types,
                          [](const auto& entry) { return three_bead_form(entry.second).has_value(); }) &&
      std::ranges::all_of(layout.swimmers, [](const Swimmer& swimmer) {
        return !swimmer.turn && (!swimmer.driving || three_bead_form(*swimmer.driving));
      });
  return one ? Version::one : Version::two;
}

// --- types

/// Converts JSON to a swimmer type. Driving parameters that the JSON omits keep their default values.
SwimmerType type_from(Json json, Version version) {
  if (version == Version::two) return shape_from_json(json);
  json["driving"] = override_driving({}, json["driving"]);
  return swimmer_type(json.get<ThreeBeadSwimmer>());
}

// --- swimmers

Swimmer swimmer_from(const Json& json, const std::map<std::string, SwimmerType>& types, Version version) {
  Swimmer swimmer{.id = json["id"].get<int>(),
                  .type = json["type"].get<std::string>(),
                  .position = json["position"].get<Vec3>()};
  if (json.contains("orientation")) {
    const auto [w, x, y, z] = json["orientation"].get<std::array<double, 4>>();
    swimmer.turn.emplace(w, x, y, z);
  } else if (json.contains("axis")) {
    json["axis"].get_to(swimmer.axis);
  }
  const auto type = types.find(swimmer.type);  // check_layout reports unknown types
  if (json.contains("driving") && type != types.end() && version == Version::two) {
    swimmer.driving = override_shape_driving(type->second.driving, json["driving"]);
  } else if (json.contains("driving") && type != types.end()) {
    swimmer.driving = drives(override_driving(three_beads(type->second).driving, json["driving"]));
  }
  return swimmer;
}

Json json_of(const Swimmer& swimmer, const SwimmerType& type, Version version) {
  Json json{{"id", swimmer.id}, {"type", swimmer.type}, {"position", swimmer.position}};
  if (swimmer.turn) {
    json["orientation"] = {swimmer.turn->w(), swimmer.turn->x(), swimmer.turn->y(), swimmer.turn->z()};
  } else {
    json["axis"] = swimmer.axis;
  }
  if (swimmer.driving && version == Version::two) {
    Json own = shape_driving_difference(*swimmer.driving, type.driving);
    if (!own.empty()) json["driving"] = std::move(own);
  } else if (swimmer.driving) {
    Json own = difference(*three_bead_form(*swimmer.driving), three_beads(type).driving);
    if (!own.empty()) json["driving"] = std::move(own);
  }
  return json;
}

/// Appends fluid, domain, flow, body force, types and swimmers to a JSON object.
void add_scene(Json& json, const Layout& layout, Version version) {
  json["fluid"] = layout.fluid;
  json["domain"] = layout.domain;
  if (!layout.flow.is_zero()) json["flow"] = layout.flow;
  if (!layout.body_force.isZero(0)) json["body_force"] = layout.body_force;
  json["types"] = Json::object();
  json["swimmers"] = Json::array();
  for (const auto& [name, type] : layout.types)
    json["types"][name] = version == Version::one ? Json(three_beads(type)) : shape_to_json(type);
  for (const Swimmer& swimmer : layout.swimmers)
    json["swimmers"].push_back(json_of(swimmer, layout.types.at(swimmer.type), version));
}

Layout layout_from(const Json& json, Version version) {
  Layout layout;
  layout.units = units_from(json["units"]);
  json["fluid"].get_to(layout.fluid);
  json["domain"].get_to(layout.domain);
  if (json.contains("flow")) json["flow"].get_to(layout.flow);
  if (json.contains("body_force")) json["body_force"].get_to(layout.body_force);
  for (const auto& [name, type] : json["types"].items()) layout.types[name] = type_from(type, version);
  for (const Json& swimmer : json["swimmers"])
    layout.swimmers.push_back(swimmer_from(swimmer, layout.types, version));
  if (json.contains("resolution")) json["resolution"].get_to(layout.resolution);
  return layout;
}

}  // namespace

LayoutDocument layout_from_json(const Json& json, const std::string& source) {
  const Json schema = json.is_object() ? json.value("schema", Json()) : Json();
  const bool is_one = !schema.is_string() || schema == schema_one ||
                      !schema.get<std::string>().starts_with("beadswim/layout/");
  const Version version = is_one ? Version::one : Version::two;
  if (schema == schema_one) refuse_absent_features(json, source);
  validate_json(json, version == Version::one ? "layout" : "layout-2", source);
  if (version == Version::two) throw_if_faulty(source, shape_faults(json));

  LayoutDocument document{.layout = layout_from(json, version),
                          .provenance = json.value("provenance", Json::array()),
                          .study = json.value("study", Json())};
  normalise_axes(document.layout);
  std::vector<DocumentFault> faults;
  for (const LayoutFault& fault : check_layout(document.layout))
    faults.push_back({fault.place, fault.message});
  throw_if_faulty(source, faults);
  return document;
}

LayoutDocument layout_of(const StreamMember& member) {
  return layout_from_json(parse_json(member.text, member.source), member.source);
}

LayoutDocument read_layout(const std::string& path) {
  return layout_of({.text = read_text(path), .source = path == "-" ? "standard input" : path});
}

Json layout_to_json(const LayoutDocument& document) {
  const Layout& layout = document.layout;
  const Version version = version_of(layout);
  Json json{{"schema", version == Version::one ? schema_one : schema_two}, {"units", json_of(layout.units)}};
  add_scene(json, layout, version);
  if (layout.resolution) json["resolution"] = layout.resolution;
  if (!document.study.is_null()) json["study"] = document.study;
  json["provenance"] = document.provenance;
  return json;
}

Json scene_to_json(const Layout& layout) {
  Json json;
  add_scene(json, layout, version_of(layout));
  return json;
}

Layout scene_from_json(const Json& scene, const Units& units, const std::string& source) {
  const auto is_shape = [](const Json& type) { return type.is_object() && !type.contains("springs"); };
  const bool two = scene.contains("types") && std::ranges::any_of(scene["types"], is_shape);
  Json json{{"schema", two ? schema_two : schema_one}, {"units", "lattice"}};
  json.update(scene);
  Layout layout = layout_from_json(json, "the scene in " + source).layout;
  layout.units = units;
  return layout;
}

}  // namespace beadswim
