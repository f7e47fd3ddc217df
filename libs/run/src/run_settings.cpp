#include "beadswim/run/run_settings.hpp"

#include <cmath>
#include <vector>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// Returns why a setting of this scope has no effect in runs with the model.
std::string reason_against_scope(SettingScope scope, RunModel model) {
  if (scope == SettingScope::lattice)
    return fmt::format("the setting applies to the lattice only; leave it out, or use {} lbm instead of {}",
                       Setting::model, to_text(model));
  if (scope == SettingScope::moments && model != RunModel::lbm)
    return fmt::format(
        "the setting applies to the models multipole and unsteady only; leave it out, or add {} multipole",
        Setting::model);
  if (scope == SettingScope::unsteady && model != RunModel::lbm)
    return fmt::format("the setting applies to the model unsteady only; leave it out, or add {} unsteady",
                       Setting::model);
  return fmt::format(
      "the setting applies to mobility models only; leave it out, or add {} rpy, rpy+near, multipole, oseen "
      "or unsteady",
      Setting::model);
}

/// Calls visit(row, value in `one`, value in `other`) for all settings, with the values as text.
void for_each_setting(const RunSettings& one, const RunSettings& other, const auto& visit) {
  std::vector<std::string> texts;
  const auto add = [&](const char*, const auto& value, const SettingRow& row) {
    texts.push_back(setting_text(row, value));
  };
  visit_fields(add, other);
  auto text = texts.begin();
  const auto visit_both = [&](const char*, const auto& value, const SettingRow& row) {
    visit(row, setting_text(row, value), *text++);
  };
  visit_fields(visit_both, one);
}

/// Returns why a number is outside the range of a setting; empty if it is inside.
std::string range_fault(const SettingRow& row, double number) {
  const bool allows_low = row.allows_low || std::isfinite(row.high);
  const bool is_inside =
      std::isfinite(number) && number <= row.high && (allows_low ? number >= row.low : number > row.low);
  if (is_inside) return {};
  if (!row.too_low.empty() && number > 0)
    return fmt::format("{} is not above {}, so that {}", number, row.low, row.too_low);
  if (std::isfinite(row.high)) return fmt::format("{} is not between {} and {}", number, row.low, row.high);
  return fmt::format("{} is not a finite number {} {}", number,
                     row.allows_low ? "of at least" : "greater than", row.low);
}

}  // namespace

bool applies(const SettingRow& row, RunModel model) {
  const auto mobility = mobility_model(model);
  switch (row.scope) {
    case SettingScope::all:
      return true;
    case SettingScope::lattice:
      return !mobility;
    case SettingScope::mobility:
      return mobility.has_value();
    case SettingScope::moments:
      return mobility && has_moment_order(*mobility);
    case SettingScope::unsteady:
      return model == RunModel::unsteady;
  }
  return false;
}

void require_settings_apply(const std::set<Setting>& chosen, RunModel model) {
  const RunSettings any;
  visit_fields(
      [&](const char*, const auto&, const SettingRow& row) {
        if (chosen.contains(row.setting) && !applies(row, model))
          throw InputError(row.setting, reason_against_scope(row.scope, model));
      },
      any);
}

void require_ranges(const RunSettings& settings) {
  visit_fields(
      [&]<class T>(const char*, const T& value, const SettingRow& row) {
        std::optional<double> number;
        if constexpr (std::same_as<T, double> || std::same_as<T, int>) number = value;
        if constexpr (is_optional<T>) number = value ? std::optional<double>(*value) : std::nullopt;
        const bool is_word = number && *number == 0 && !row.word_of_zero.empty();
        if (!number || is_word) return;
        if (const std::string fault = range_fault(row, *number); !fault.empty())
          throw InputError(row.setting, fault + "; give another value");
      },
      settings);
}

std::string settings_text(const RunSettings& settings, const std::set<Setting>& chosen) {
  std::string text;
  const auto add = [&](const SettingRow& row, const std::string& value, const std::string& usual) {
    const bool is_usual = value == row.word_of_none || (value == usual && !chosen.contains(row.setting));
    const bool is_of_model =
        row.scope != SettingScope::all && row.changes_results && applies(row, settings.model);
    if (row.setting == Setting::model || (is_of_model && (row.is_always_named || !is_usual)))
      text += fmt::format("{}{} {}", text.empty() ? "" : " ", row.setting, value);
  };
  for_each_setting(settings, {}, add);
  return text;
}

std::optional<SettingDifference> find_difference(
    const RunSettings& wanted, const RunSettings& present,
    const std::function<bool(const SettingRow&)>& must_be_equal) {
  std::optional<SettingDifference> found;
  const auto compare = [&](const SettingRow& row, const std::string& wants, const std::string& is) {
    if (found || wants.empty() || wants == is || !must_be_equal(row)) return;
    found = {.setting = row.setting, .wanted = wants, .present = is.empty() ? "the default" : is};
  };
  for_each_setting(wanted, present, compare);
  return found;
}

}  // namespace beadswim
