#include "beadswim/study/quantity.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/io/fields_json.hpp"
#include "beadswim/scene/combine.hpp"
#include "beadswim/study/named_quantity.hpp"

namespace beadswim {
namespace {

bool is_pointer(const std::string& name) {
  return name.starts_with('/');
}

/// Returns the steps of a JSON pointer.
std::vector<std::string> steps_of(const std::string& pointer) {
  std::vector<std::string> steps;
  for (Json::json_pointer rest(pointer); !rest.empty(); rest.pop_back()) steps.push_back(rest.back());
  std::ranges::reverse(steps);
  return steps;
}

/// Returns the place to which a JSON pointer leads. Adds the keys that objects lack, whose names the reader
/// of layouts checks; a new value is null. Throws InputError if the pointer leads to an entry that a list
/// lacks, or to a list or an object that the value, if it is a list, is not as long as.
Json& value_at(Json& layout, const std::string& pointer, const Json& value, const std::string& source,
               const std::string& flag) {
  Json* place = &layout;
  std::string done;
  for (const std::string& step : steps_of(pointer)) {
    const std::string where = done.empty() ? source : source + ":" + done;
    if (place->is_null()) *place = Json::object();
    if (place->is_object()) {
      place = &(*place)[step];
    } else if (place->is_array()) {
      std::size_t index = 0;
      const auto [end, fault] = std::from_chars(step.data(), step.data() + step.size(), index);
      if (fault != std::errc() || end != step.data() + step.size() || index >= place->size())
        throw InputError(flag,
                         "\"{}\" leads to nothing: {} has {} entries, numbered from 0, and none is \"{}\"",
                         pointer, where, place->size(), step);
      place = &(*place)[index];
    } else {
      throw InputError(flag, "\"{}\" leads to nothing: {} is a single value", pointer, where);
    }
    done += "/" + step;
  }
  if (place->is_structured() && !(place->is_array() && value.is_array() && place->size() == value.size()))
    throw InputError(flag,
                     "\"{}\" leads to a list or an object; add the steps to one number or word in it, or "
                     "give lists of the same length",
                     pointer);
  return *place;
}

/// Adds the flow or body force to which a JSON pointer leads, zero, if the layout lacks it.
void add_left_out(Json& layout, const std::string& pointer) {
  if (pointer.starts_with("/flow/") && !layout.contains("flow")) layout["flow"] = BackgroundFlow{};
  if (pointer.starts_with("/body_force/") && !layout.contains("body_force")) layout["body_force"] = {0, 0, 0};
}

/// Returns true if the driving of a swimmer in a layout document has the quantity, instead of its type.
bool has_own(const Json& swimmer, const std::string& name) {
  if (!swimmer.contains("driving")) return false;
  const Json& driving = swimmer["driving"];
  const bool is_of_harmonics = name == "amplitude" || name == "phase";
  return driving.contains(name) ||
         (is_of_harmonics && std::ranges::any_of(std::array{"forces", "bonds", "angles"},
                                                 [&](const char* key) { return driving.contains(key); }));
}

/// Throws InputError if all swimmers have their own value of the quantity, so that a value of their types
/// changes nothing.
void require_effect(const Json& layout, const std::string& name, const std::string& source,
                    const std::string& flag) {
  const Json& swimmers = layout["swimmers"];
  if (!std::ranges::all_of(swimmers, [&](const Json& swimmer) { return has_own(swimmer, name); })) return;
  throw InputError(flag,
                   "\"{0}\" changes no swimmer: each swimmer of {1} has its own {0}, which stays; remove it "
                   "from the swimmers, or name one by a JSON pointer, such as /swimmers/0/driving/{0}",
                   name, source);
}

/// Returns true for a name such as /swimmers/0/rotate/z.
bool is_turn(const std::string& name) {
  const std::vector<std::string> steps = is_pointer(name) ? steps_of(name) : std::vector<std::string>{};
  return steps.size() == 4 && steps[0] == "swimmers" && steps[2] == "rotate";
}

/// Turns the swimmer to which a name such as /swimmers/0/rotate/z leads.
void turn_named(Layout& layout, const std::string& name, const Json& angle, const std::string& flag) {
  const std::vector<std::string> steps = steps_of(name);
  const std::size_t axis = steps[3].size() == 1 ? std::string("xyz").find(steps[3]) : std::string::npos;
  std::size_t s = 0;
  const auto [end, fault] = std::from_chars(steps[1].data(), steps[1].data() + steps[1].size(), s);
  if (axis == std::string::npos || fault != std::errc() || s >= layout.swimmers.size() || !angle.is_number())
    throw InputError(flag,
                     "\"{}\" turns no swimmer; write /swimmers/N/rotate/AXIS=ANGLE,... with a number N from "
                     "0 to {}, an axis x, y or z and angles such as 90deg",
                     name, layout.swimmers.size() - 1);
  Swimmer& swimmer = layout.swimmers[s];
  turn_swimmer(
      swimmer, layout.resolved_type(swimmer),
      Eigen::Quaterniond(Eigen::AngleAxisd(angle.get<double>(), Vec3::Unit(static_cast<int>(axis)))));
}

/// Returns the value as a user writes it: a word, a number or numbers joined by commas.
std::string text_of(const Json& value) {
  if (value.is_array()) return joined(value.get<std::vector<double>>(), ",");
  return value.is_string() ? value.get<std::string>() : fmt::format("{}", value.get<double>());
}

/// Returns the layout with the values in its types and its fluid. The swimmers keep the drivings of their
/// own.
Json with_named_values(const LayoutDocument& document, const QuantityValues& values,
                       const std::string& source) {
  LayoutDocument changed = document;
  set_quantities(changed.layout, values, source);
  Json json = layout_to_json(document);
  const Json with = layout_to_json(changed);
  for (const char* key : {"fluid", "types", "resolution"})
    if (with.contains(key)) json[key] = with[key];
  return json;
}

}  // namespace

std::string quantity_name(const std::string& text, const std::string& flag) {
  const std::string name = text.starts_with("--") ? text.substr(2) : text;
  std::vector<std::string> names;
  for (const NamedQuantity& quantity : named_quantities()) names.push_back(quantity.name);
  if (!is_pointer(name) && !find_quantity(name))
    throw InputError(flag,
                     "\"{}\": {}; anything else in a layout has a JSON pointer, such as /domain/lengths/0",
                     text, format_unknown_name(name, names));
  if (!is_pointer(name)) return name;
  try {
    Json::json_pointer{name};
    return name;
  } catch (const Json::exception&) {
    throw InputError(flag, "\"{}\": this is no JSON pointer; in its steps, ~ is written as ~0 and / as ~1",
                     text);
  }
}

LayoutDocument with_values(const Json& layout, const StudyPoint& point, const std::string& source,
                           const std::string& flag, const StudyPoint& present) {
  Json json = layout;
  QuantityValues named;
  StudyPoint turns;
  std::string values;
  for (const StudyPoint* values_of : {&point, &present})
    for (const auto& [name, value] : *values_of)
      values += fmt::format("{}{}={}", values.empty() ? "" : ", ", name, text_of(value));
  for (const auto& [name, value] : point) {
    if (is_turn(name)) {
      turns.emplace_back(name, value);
    } else if (is_pointer(name)) {
      add_left_out(json, name);
      Json& place = value_at(json, name, value, source, flag);
      const bool is_whole = (place.is_null() || place.is_number_integer()) && value.is_number() &&
                            std::trunc(value.get<double>()) == value.get<double>() &&
                            std::abs(value.get<double>()) < 1e15;
      place = is_whole ? Json(static_cast<std::int64_t>(value.get<double>())) : value;
    } else {
      const std::string fault = value_fault(*find_quantity(name), value);
      if (!fault.empty()) throw InputError(flag, "{}: {}", name, fault);
      named[name] = value;
    }
  }
  const std::string changed = fmt::format("{} with {}", source, values);
  LayoutDocument document = layout_from_json(json, changed);
  for (const auto& [name, value] : named) require_effect(json, name, source, flag);
  if (!named.empty()) document = layout_from_json(with_named_values(document, named, source), changed);
  for (const auto& [name, value] : turns) turn_named(document.layout, name, value, flag);
  if (!turns.empty()) document = layout_from_json(layout_to_json(document), changed);
  document.made_by = {};
  if (document.study.is_null()) document.study = Json::object();
  for (const StudyPoint* values_of : {&point, &present}) {
    for (const auto& [name, value] : *values_of) {
      if (document.study.contains(name))
        throw InputError(source,
                         "the layout belongs to a study of \"{}\" already; vary something else, or start "
                         "from a layout without \"study\"",
                         name);
      document.study[name] = value.is_array() ? Json(text_of(value)) : value;
    }
  }
  return document;
}

std::vector<StudyPoint> study_points(const std::vector<Variation>& variations, bool together,
                                     const std::string& flag) {
  std::set<std::string> names;
  for (const Variation& variation : variations)
    if (!names.insert(variation.name).second)
      throw InputError(flag, "\"{}\" is named twice; give all its values at once", variation.name);
  std::size_t count = together ? variations.front().values.size() : 1;
  for (const Variation& variation : variations) {
    if (!together) count *= variation.values.size();
    if (count > max_study_points)
      throw InputError(flag, "the grid has more than {} layouts; give fewer values", max_study_points);
  }
  std::vector<StudyPoint> points(count);
  for (std::size_t p = 0; p < count; ++p) {
    std::size_t rest = p;
    for (auto variation = variations.rbegin(); variation != variations.rend(); ++variation) {
      const std::size_t values = variation->values.size();
      points[p].emplace_back(variation->name, variation->values[together ? p : rest % values]);
      rest /= values;
    }
    std::ranges::reverse(points[p]);
  }
  return points;
}

}  // namespace beadswim
