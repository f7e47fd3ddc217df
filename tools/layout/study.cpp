#include "study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "beadswim/tools/program.hpp"
#include "swimmer_flags.hpp"

namespace beadswim {
namespace {

constexpr const char* over = "--over";
constexpr std::size_t max_values = 1000000;

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError(over, fmt::format("\"{}\": {}", text, why));
}

/// Returns the number, an angle with the ending deg as radians; nullopt if the text is no finite number.
std::optional<double> number(const std::string& text) {
  if (text.empty() || !angle()(text).empty()) return std::nullopt;
  return parse_angle(text);
}

double number_or_refuse(const std::string& text, const std::string& all) {
  if (const auto value = number(text)) return *value;
  refuse(all,
         fmt::format("\"{}\" is not a finite number; write NAME=FROM:TO:COUNT, such as period=1000:8000:8",
                     text));
}

std::size_t count_or_refuse(const std::string& text, const std::string& all) {
  std::size_t count = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (fault == std::errc() && end == text.data() + text.size() && count >= 2 && count <= max_values)
    return count;
  refuse(all,
         fmt::format("the number of values, \"{}\", must be a whole number from 2 to {}", text, max_values));
}

std::vector<Json> range(const std::vector<std::string>& parts, const std::string& all) {
  const bool is_log = parts.size() == 4 && parts[3] == "log";
  if (parts.size() < 3 || parts.size() > 4 || (parts.size() == 4 && !is_log))
    refuse(all, "a range is FROM:TO:COUNT or FROM:TO:COUNT:log");
  const double from = number_or_refuse(parts[0], all), to = number_or_refuse(parts[1], all);
  const std::size_t count = count_or_refuse(parts[2], all);
  if (is_log && !(from > 0 && to > 0)) refuse(all, "a logarithmic range needs two numbers above 0");
  std::vector<Json> values;
  for (std::size_t n = 0; n < count; ++n) {
    const double share = static_cast<double>(n) / static_cast<double>(count - 1);
    values.push_back(n == 0           ? from
                     : n == count - 1 ? to
                     : is_log         ? from * std::pow(to / from, share)
                                      : from + share * (to - from));
  }
  return values;
}

std::vector<Json> list(const std::string& text, const std::string& all) {
  std::vector<Json> values;
  for (const std::string& part : split_at_commas(text)) {
    if (part.empty()) refuse(all, "a value is missing; write NAME=VALUE,VALUE,...");
    if (const auto value = number(part)) {
      values.emplace_back(*value);
    } else {
      values.emplace_back(part);
    }
  }
  return values;
}

/// Returns the steps of a JSON pointer.
std::vector<std::string> steps_of(const std::string& pointer) {
  std::vector<std::string> steps;
  for (Json::json_pointer rest(pointer); !rest.empty(); rest.pop_back()) steps.push_back(rest.back());
  std::ranges::reverse(steps);
  return steps;
}

/// Returns the place to which a JSON pointer leads. Throws InputError if it leads to nothing or to a list or
/// an object.
Json& value_at(Json& layout, const std::string& pointer, const std::string& source) {
  Json* place = &layout;
  std::string done;
  for (const std::string& step : steps_of(pointer)) {
    const std::string where = done.empty() ? source : source + ":" + done;
    if (place->is_object()) {
      if (!place->contains(step)) {
        std::vector<std::string> keys;
        for (const auto& [key, value] : place->items()) keys.push_back(key);
        throw InputError(over, fmt::format("\"{}\" leads to nothing: {} has no key \"{}\"{}", pointer, where,
                                           step, format_suggestion(step, keys)));
      }
      place = &(*place)[step];
    } else if (place->is_array()) {
      std::size_t index = 0;
      const auto [end, fault] = std::from_chars(step.data(), step.data() + step.size(), index);
      if (fault != std::errc() || end != step.data() + step.size() || index >= place->size())
        throw InputError(over, fmt::format("\"{}\" leads to nothing: {} has {} entries, numbered from 0, and "
                                           "none is \"{}\"",
                                           pointer, where, place->size(), step));
      place = &(*place)[index];
    } else {
      throw InputError(over, fmt::format("\"{}\" leads to nothing: {} is a single value", pointer, where));
    }
    done += "/" + step;
  }
  if (place->is_structured())
    throw InputError(over, fmt::format("\"{}\" leads to a list or an object; add the steps to one number or "
                                       "word in it",
                                       pointer));
  return *place;
}

/// Replaces types and fluid of the layout by those with the values of flags.
Json with_flags(const LayoutDocument& document, const std::vector<std::string>& arguments,
                const std::string& source) {
  LayoutDocument changed = document;
  CLI::App command("", "beadswim-layout vary: --over");
  const SwimmerFlags flags(command, {}, "");
  std::vector<const char*> words{"beadswim-layout"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  parse_command_line(command, static_cast<int>(words.size()), words.data());
  flags.apply(changed.layout, source);
  Json json = layout_to_json(document);
  const Json with = layout_to_json(changed);
  for (const char* key : {"fluid", "types", "resolution"})
    if (with.contains(key)) json[key] = with[key];
  return json;
}

}  // namespace

Variation parse_variation(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    refuse(text, "write NAME=FROM:TO:COUNT, NAME=FROM:TO:COUNT:log or NAME=VALUE,VALUE,...");
  Variation variation{.name = text.substr(0, equals), .values = {}};
  const std::string values = text.substr(equals + 1);
  const std::vector<std::string>& names = SwimmerFlags::single_values();
  if (variation.name.starts_with("--")) variation.name.erase(0, 2);
  if (!variation.is_pointer() && std::ranges::find(names, variation.name) == names.end())
    refuse(text, format_unknown_name(variation.name, names) +
                     "; anything else in a layout has a JSON pointer, such as /domain/lengths/0");
  if (variation.is_pointer()) {
    try {
      Json::json_pointer{variation.name};
    } catch (const Json::exception&) {
      refuse(text, "this is no JSON pointer; in its steps, ~ is written as ~0 and / as ~1");
    }
  }
  const std::vector<std::string> parts = split_at(':', values);
  variation.values = parts.size() > 1 ? range(parts, text) : list(values, text);
  return variation;
}

std::vector<StudyPoint> study_points(const std::vector<Variation>& variations, bool together) {
  std::set<std::string> names;
  for (const Variation& variation : variations)
    if (!names.insert(variation.name).second)
      throw InputError(over,
                       fmt::format("\"{}\" is named twice; give all its values at once", variation.name));
  const std::size_t first = variations.front().values.size();
  std::size_t count = together ? first : 1;
  for (const Variation& variation : variations) {
    if (together && variation.values.size() != first)
      throw InputError("--together",
                       fmt::format("\"{}\" has {} values and \"{}\" has {}; give equally many",
                                   variations.front().name, first, variation.name, variation.values.size()));
    if (!together) count *= variation.values.size();
    if (count > max_values)
      throw InputError(over, fmt::format("the grid has more than {} layouts; give fewer values", max_values));
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

LayoutDocument with_values(const Json& layout, const StudyPoint& point, const std::string& source) {
  Json json = layout;
  std::vector<std::string> arguments;
  std::string values;
  for (const auto& [name, value] : point) {
    const std::string text =
        value.is_string() ? value.get<std::string>() : fmt::format("{}", value.get<double>());
    values += fmt::format("{}{}={}", values.empty() ? "" : ", ", name, text);
    if (name.starts_with('/')) {
      Json& place = value_at(json, name, source);
      const bool is_whole = place.is_number_integer() && value.is_number() &&
                            std::trunc(value.get<double>()) == value.get<double>() &&
                            std::abs(value.get<double>()) < 1e15;
      place = is_whole ? Json(static_cast<std::int64_t>(value.get<double>())) : value;
    } else {
      arguments.push_back(fmt::format("--{}={}", name, text));
    }
  }
  const std::string changed = fmt::format("{} with {}", source, values);
  LayoutDocument document = layout_from_json(json, changed);
  if (!arguments.empty()) document = layout_from_json(with_flags(document, arguments, source), changed);
  if (document.study.is_null()) document.study = Json::object();
  for (const auto& [name, value] : point) {
    if (document.study.contains(name))
      throw InputError(source, fmt::format("the layout belongs to a study of \"{}\" already; vary something "
                                           "else, or start from a layout without \"study\"",
                                           name));
    document.study[name] = value;
  }
  return document;
}

}  // namespace beadswim
