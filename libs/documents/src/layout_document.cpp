#include "beadswim/documents/layout_document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "beadswim/io/schema.hpp"
#include "beadswim/scene/check.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"
#include "layout_json.hpp"

namespace beadswim {
namespace {

constexpr const char *schema_one = "beadswim/layout/1", *schema_two = "beadswim/layout/2";

const std::array<std::pair<const char*, Quantity>, 3> quantities{
    {{"length", Quantity::length}, {"time", Quantity::time}, {"mass", Quantity::mass}}};

/// Version 1 of layouts describes the paper's three-bead swimmers, version 2 swimmers of any shape. The JSON
/// of version 1 contains three_bead_form() of types and drivings.
enum class Version { one, two };

/// Returns the version with which a layout is written: 1 if it can express the layout.
Version version_of(const Layout& layout) {
  const bool one =
      std::ranges::all_of(layout.types,
                          [](const auto& entry) { return three_bead_form(entry.second).has_value(); }) &&
      std::ranges::all_of(layout.swimmers, [](const Swimmer& swimmer) {
        return !swimmer.turn && !swimmer.start && (!swimmer.driving || three_bead_form(*swimmer.driving));
      });
  return one ? Version::one : Version::two;
}

Json json_of(const Driving& driving, Version version) {
  return version == Version::one ? Json(*three_bead_form(driving)) : Json(driving);
}

/// Returns the members of a swimmer's driving that differ from `of_type`, the driving of the swimmer's type.
Json difference(Json driving, const Json& of_type) {
  for (const auto& [key, value] : of_type.items()) {
    if (!driving.contains(key)) {  // the member has its default, which the driving of the type has not
      driving[key] = key == "phase_offset" ? Json(0.0) : key == "net_force" ? Json("zero") : Json::array();
    } else if (driving[key] == value) {
      driving.erase(key);
    }
  }
  return driving;
}

/// Returns a copy of `driving` in which the members that `json` contains are replaced.
template <class AnyDriving>
AnyDriving overridden(AnyDriving driving, const Json& json) {
  json.get_to(driving);
  return driving;
}

/// Completes the JSON of a layout: types and drivings in the form of the version.
void add_drivings(Json& json, const Layout& layout, Version version) {
  for (const auto& [name, type] : layout.types)
    if (version == Version::one) json["types"][name] = three_beads(type);
  for (std::size_t s = 0; s < layout.swimmers.size(); ++s) {
    const Swimmer& swimmer = layout.swimmers[s];
    if (!swimmer.driving) continue;
    const Driving& of_type = layout.types.at(swimmer.type).driving;
    Json own = difference(json_of(*swimmer.driving, version), json_of(of_type, version));
    if (!own.empty()) json["swimmers"][s]["driving"] = std::move(own);
  }
}

/// Reads the drivings of the swimmers of a layout.
void read_drivings(const Json& swimmers, Layout& layout, Version version) {
  for (std::size_t s = 0; s < layout.swimmers.size(); ++s) {
    const auto type = layout.types.find(layout.swimmers[s].type);  // check_layout reports unknown types
    if (!swimmers[s].contains("driving") || type == layout.types.end()) continue;
    const Json& own = swimmers[s]["driving"];
    layout.swimmers[s].driving = version == Version::one
                                     ? drives(overridden(three_beads(type->second).driving, own))
                                     : overridden(type->second.driving, own);
  }
}

void add_drive_faults(const Json& driving, const std::string& place, std::vector<DocumentFault>& faults) {
  const Json drives = driving.value("bonds", Json::array());
  for (std::size_t n = 0; n < drives.size(); ++n) {
    if (drives[n].contains("tension") != drives[n].contains("rest_length")) continue;
    faults.push_back(
        {fmt::format("{}/bonds/{}", place, n),
         "a drive of a bond needs exactly one of the keys \"tension\" and \"rest_length\"; write "
         "two drives to change both"});
  }
}

/// Returns faults of a layout of version 2 that its schema does not know: swimmers with axis and orientation,
/// and drives of bonds without or with both of tension and rest length.
std::vector<DocumentFault> faults_beyond_schema(const Json& layout) {
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

struct AbsentFeature {
  std::set<std::string_view> keys;
  const char* explanation;
};

/// Keys of a layout that request physics which this version does not have, such as an imposed flow or a
/// prescribed stroke.
const std::array<AbsentFeature, 4> absent_features{
    {{{"background_flow", "imposed_flow", "external_flow", "inflow", "shear", "shear_rate", "strain_rate",
       "velocity_gradient", "pressure_gradient", "wall_velocity", "wall_velocities"},
      "imposed flow has other keys: \"flow\" of the layout for a linear flow of unbounded fluid, "
      "\"body_force\" and moving walls for flow between no-slip walls; remove the key"},
     {{"stroke", "strokes", "prescribed_stroke", "kinematics", "gait", "waveform", "arm_length",
       "arm_lengths", "arm_amplitudes", "arm_phases", "rest_length", "rest_lengths"},
      "version 1 of the layout has no prescribed stroke: harmonic forces drive the beads (amplitude, phase, "
      "period of \"driving\"); remove the key, or prescribe lengths and angles in a layout of version 2 "
      "(beadswim-layout shape prescribed-three-bead)"},
     {{"temperature", "kT", "thermal_noise", "noise"},
      "thermal noise has the key \"thermal_energy\" of \"fluid\", k_B T in the units of the layout; remove "
      "this "
      "key"},
     {{"gravity", "external_force"},
      "this version has no gravity; remove the key, or set constant forces on beads "
      "in a layout of version 2 with the key net_force (beadswim-layout shape sphere)"}}};

/// Throws InputError if a key of the JSON object requests a feature that this version does not have. Does
/// nothing if the value is not an object.
void refuse_keys(const Json& object, const std::string& place) {
  if (!object.is_object()) return;
  for (const auto& [key, value] : object.items()) {
    for (const AbsentFeature& feature : absent_features) {
      if (feature.keys.contains(key)) throw InputError(place + "/" + key, feature.explanation);
    }
  }
}

const Json& member(const Json& object, const char* key) {
  static const Json nothing;
  return object.is_object() && object.contains(key) ? object[key] : nothing;
}

/// Throws InputError for the first key of a layout that requests physics which this version does not have,
/// such as an imposed flow or a prescribed stroke. Other unknown keys are reported by the schema validation.
void refuse_absent_features(const Json& layout, const std::string& source) {
  refuse_keys(layout, source + ":");
  for (const char* part : {"fluid", "domain"}) refuse_keys(member(layout, part), source + ":/" + part);
  const auto refuse_in = [&](const Json& object, const std::string& place) {
    refuse_keys(object, place);
    refuse_keys(member(object, "driving"), place + "/driving");
  };
  for (const auto& [name, type] : member(layout, "types").items())
    refuse_in(type, source + ":/types/" + name);
  const Json& swimmers = member(layout, "swimmers");
  if (!swimmers.is_array()) return;
  for (std::size_t s = 0; s < swimmers.size(); ++s)
    refuse_in(swimmers[s], source + ":/swimmers/" + std::to_string(s));
}

}  // namespace

LayoutDocument layout_from_json(const Json& json, const std::string& source) {
  const Json schema = json.is_object() ? json.value("schema", Json()) : Json();
  const bool is_one = !schema.is_string() || schema == schema_one ||
                      !schema.get<std::string>().starts_with("beadswim/layout/");
  const Version version = is_one ? Version::one : Version::two;
  if (schema == schema_one) refuse_absent_features(json, source);
  validate_json(json, version == Version::one ? "layout" : "layout-2", source);
  if (version == Version::two) throw_if_faulty(source, faults_beyond_schema(json));

  LayoutDocument document = json.get<LayoutDocument>();
  read_drivings(json["swimmers"], document.layout, version);
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
  Json json{{"schema", version == Version::one ? schema_one : schema_two}};
  add_fields(json, document);
  add_drivings(json, layout, version);
  for (const auto& [key, quantity] : quantities)
    if (!layout.units.lattice && find_known_unit(quantity, json["units"][key]["name"]))
      json["units"][key] = Json(json["units"][key]["name"]);
  return json;
}

Json scene_to_json(const Layout& layout) {
  Json json = layout;
  add_drivings(json, layout, version_of(layout));
  for (const char* key : {"units", "resolution"}) json.erase(key);
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

std::string study_value_text(const Json& value, int digits) {
  return value.is_string() ? value.get<std::string>() : fmt::format("{:.{}g}", value.get<double>(), digits);
}

std::string study_text(const Json& study, int digits) {
  std::string text;
  for (const auto& [name, value] : study.items())
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, study_value_text(value, digits));
  return text;
}

}  // namespace beadswim
