#include "variation_text.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/tools/program.hpp"
#include "made_layout.hpp"

namespace beadswim {
namespace {

constexpr const char* over = "--over";

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError(over, "\"{}\": {}", text, why);
}

/// Returns the number, an angle with the ending deg in radian; nullopt if the text is no finite number.
std::optional<double> number_in(const std::string& text) {
  return text.empty() || !angle()(text).empty() ? std::nullopt : std::optional(parse_angle(text));
}

double number_or_refuse(const std::string& text, const std::string& all) {
  if (const auto value = number_in(text)) return *value;
  refuse(all,
         fmt::format("\"{}\" is not a finite number; write NAME=FROM:TO:COUNT, such as period=1000:8000:8",
                     text));
}

std::size_t count_or_refuse(const std::string& text, const std::string& all) {
  std::size_t count = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (fault == std::errc() && end == text.data() + text.size() && count >= 2 && count <= max_study_points)
    return count;
  refuse(all, fmt::format("the number of values, \"{}\", must be a whole number from 2 to {}", text,
                          max_study_points));
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
  if (text.starts_with('[')) {
    const Json lists = Json::parse("[" + text + "]", nullptr, false);
    const auto is_list = [](const Json& value) {
      return value.is_array() && std::ranges::all_of(value, [](const Json& x) { return x.is_number(); });
    };
    if (!lists.is_array() || !std::ranges::all_of(lists, is_list))
      refuse(all, "lists of numbers are written as NAME=[X,Y],[X,Y],...");
    return lists;
  }
  std::vector<Json> values;
  for (const std::string& part : split_at_commas(text)) {
    if (part.empty()) refuse(all, "a value is missing; write NAME=VALUE,VALUE,...");
    const auto value = number_in(part);
    values.push_back(value ? Json(*value) : Json(part));
  }
  return values;
}

/// Returns the name of a quantity, or of a flag of a command that makes layouts.
std::string parameter_name(const std::string& text, const std::string& flag) {
  static const std::set<std::string> parameters = parameter_names();
  const std::string name = text.starts_with("--") ? text.substr(2) : text;
  return parameters.contains(name) ? name : quantity_name(text, flag);
}

}  // namespace

CoupledVariation parse_variation(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    refuse(text, "write NAME=FROM:TO:COUNT, NAME=FROM:TO:COUNT:log or NAME=VALUE,VALUE,...");
  std::vector<std::pair<std::string, double>> names;
  for (const std::string& name : split_at_commas(text.substr(0, equals))) {
    const bool is_opposite = name.size() > 1 && name[0] == '-' && name[1] != '-';
    names.emplace_back(parameter_name(is_opposite ? name.substr(1) : name, over), is_opposite ? -1 : 1);
  }
  if (names.front().second < 0)
    refuse(text, "the first name has no minus sign; it has the values themselves");
  const std::string values = text.substr(equals + 1);
  const std::vector<std::string> parts = split_at(':', values);
  return {.first = {.name = names.front().first,
                    .values = parts.size() > 1 ? range(parts, text) : list(values, text)},
          .others = {names.begin() + 1, names.end()}};
}

KeptRelation parse_relation(const std::string& text) {
  const std::size_t sign = text.find_first_of("+*:");
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size())
    throw InputError("--keep", "\"{}\": write A+B, A*B or A:B, with two names as in --over", text);
  return {.first = parameter_name(text.substr(0, sign), "--keep"),
          .second = parameter_name(text.substr(sign + 1), "--keep"),
          .sign = text[sign]};
}

void require_equal_counts(const std::vector<Variation>& variations) {
  const Variation& first = variations.front();
  for (const Variation& variation : variations)
    if (variation.values.size() != first.values.size())
      throw InputError("--together", "\"{}\" has {} values and \"{}\" has {}; give equally many", first.name,
                       first.values.size(), variation.name, variation.values.size());
}

}  // namespace beadswim
