#include "problem_text.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {
namespace {

constexpr const char *free_flag = "--free", *constraint_flag = "--subject-to";

/// Name and two ends of NAME=LOW:HIGH, as text.
struct NamedRange {
  std::string name, low, high;
};

NamedRange named_range(const std::string& text, const std::string& flag, const std::string& form) {
  const std::size_t equals = text.find('=');
  const std::vector<std::string> ends =
      split_at(':', equals == std::string::npos ? "" : text.substr(equals + 1));
  if (equals == 0 || ends.size() != 2) throw InputError(flag, "\"{}\": write {}", text, form);
  return {text.substr(0, equals), ends[0], ends[1]};
}

double number(const std::string& end, const std::string& text, const std::string& flag) {
  if (!end.empty() && angle()(end).empty()) return parse_angle(end);
  throw InputError(flag, "\"{}\": \"{}\" is not a finite number", text, end);
}

void require_order(double low, double high, const std::string& text, const std::string& flag) {
  if (low < high) return;
  throw InputError(flag, "\"{}\": the first number must be smaller than the second", text);
}

Constraint parse_constraint(const std::string& text) {
  const NamedRange range =
      named_range(text, constraint_flag, "NAME=:MAX, NAME=MIN: or NAME=MIN:MAX, such as power=:0.001");
  const std::vector<std::string> names = outcome_names();
  if (std::ranges::find(names, range.name) == names.end())
    throw InputError(constraint_flag, "\"{}\": {}", text, format_unknown_name(range.name, names));
  Constraint constraint{.outcome = from_text<ResultQuantity>(range.name)};
  if (range.low.empty() && range.high.empty())
    throw InputError(constraint_flag, "\"{}\": a number is missing before or after the colon", text);
  for (const std::string& end : {range.low, range.high})
    if (end.ends_with("deg")) throw InputError(constraint_flag, "\"{}\": this is no angle", text);
  if (!range.low.empty()) constraint.low = number(range.low, text, constraint_flag);
  if (!range.high.empty()) constraint.high = number(range.high, text, constraint_flag);
  require_order(constraint.low, constraint.high, text, constraint_flag);
  return constraint;
}

}  // namespace

std::vector<FreeValue> parse_free_values(const std::vector<std::string>& texts) {
  std::vector<FreeValue> values;
  std::set<std::string> known;
  for (const std::string& text : texts) {
    const NamedRange range = named_range(text, free_flag, "NAME=FROM:TO, such as stiffness=0.01:0.1");
    FreeValue value{
        .names = {}, .from = number(range.low, text, free_flag), .to = number(range.high, text, free_flag)};
    require_order(value.from, value.to, text, free_flag);
    if (!std::isfinite(value.is_logarithmic() ? value.to / value.from : value.to - value.from))
      throw InputError(free_flag, "\"{}\": these bounds are too far apart", text);
    for (const std::string& name : split_at_commas(range.name)) {
      value.names.push_back(quantity_name(name, free_flag));
      if (!known.insert(value.names.back()).second)
        throw InputError(free_flag, "\"{}\" is named twice; give its bounds once", name);
    }
    values.push_back(value);
  }
  return values;
}

std::vector<Constraint> parse_constraints(const std::vector<std::string>& texts) {
  std::vector<Constraint> constraints;
  for (const std::string& text : texts) {
    const Constraint constraint = parse_constraint(text);
    for (const Constraint& other : constraints)
      if (other.outcome == constraint.outcome)
        throw InputError(constraint_flag, "\"{0}\" is named twice; write {0}=MIN:MAX once",
                         to_text(constraint.outcome));
    constraints.push_back(constraint);
  }
  return constraints;
}

}  // namespace beadswim
