#include "study.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {
namespace {

constexpr const char* over = "--over";
constexpr std::size_t max_values = 1000000;

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw InputError(over, fmt::format("\"{}\": {}", text, why));
}

double number_or_refuse(const std::string& text, const std::string& all) {
  if (const auto value = quantity_value(text)) return *value;
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
    if (const auto value = quantity_value(part)) {
      values.emplace_back(*value);
    } else {
      values.emplace_back(part);
    }
  }
  return values;
}

}  // namespace

Variation parse_variation(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    refuse(text, "write NAME=FROM:TO:COUNT, NAME=FROM:TO:COUNT:log or NAME=VALUE,VALUE,...");
  Variation variation{.name = quantity_name(text.substr(0, equals), over), .values = {}};
  const std::string values = text.substr(equals + 1);
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

}  // namespace beadswim
