#include "setting_flags.hpp"

#include <fmt/core.h>

#include <cmath>
#include <concepts>
#include <string>

#include "beadswim/tools/named_flags.hpp"

namespace beadswim {
namespace {

/// Returns the validator of a number with decimals.
CLI::Validator validator_of(const SettingRow& row) {
  if (std::isfinite(row.high)) return number_between(row.low, row.high);
  if (row.allows_low) return finite_non_negative();
  if (row.too_low.empty()) return finite_positive();
  const auto fault = [row](const std::string& text) {
    std::string why = finite_positive()(text);
    if (!why.empty() || std::stod(text) > row.low) return why;
    return fmt::format("the {} {} is not above {}, so {}", to_text(row.setting), text, row.low, row.too_low);
  };
  return CLI::Validator(fault, "");
}

CLI::Validator whole_validator(const SettingRow& row) {
  return whole_number(std::llround(row.low), std::llround(row.high));
}

/// Returns the validator of a whole number, of the word for 0 and of the word for no value.
CLI::Validator validator_with_words(const SettingRow& row) {
  const auto fault = [row](const std::string& text) -> std::string {
    if (text == row.word_of_zero || text == row.word_of_none || whole_validator(row)(text).empty()) return {};
    return fmt::format("use {}, {}, or a whole number from {} to {}", row.word_of_zero, row.word_of_none,
                       row.low, row.high);
  };
  return CLI::Validator(fault, "");
}

// add_flag() adds the flag of one setting. `help` ends with the unit of the setting, if it has one.
template <NamedEnum Enum>
CLI::Option* add_flag(CLI::App& program, const SettingRow& row, const std::string& help, Enum& value) {
  return add_choice(program, name_of(row.setting), value, help);
}
CLI::Option* add_flag(CLI::App& program, const SettingRow& row, const std::string& help, bool& is_on) {
  return add_switch(program, name_of(row.setting), is_on, help);
}
CLI::Option* add_flag(CLI::App& program, const SettingRow& row, const std::string& help, int& value) {
  return program.add_option(name_of(row.setting), value, help)->check(whole_validator(row));
}
CLI::Option* add_flag(CLI::App& program, const SettingRow& row, const std::string& help, double& value) {
  return program.add_option(name_of(row.setting), value, help)->check(validator_of(row));
}
CLI::Option* add_flag(CLI::App& program, const SettingRow& row, const std::string& help,
                      std::optional<double>& value) {
  return program.add_option(name_of(row.setting), value, help)
      ->check(validator_of(row))
      ->default_str(std::string(row.unset));
}
CLI::Option* add_flag(CLI::App& program, const SettingRow& row, const std::string& help,
                      std::optional<int>& value) {
  if (row.word_of_zero.empty())
    return program.add_option(name_of(row.setting), value, help)
        ->check(whole_validator(row))
        ->default_str(std::string(row.unset));
  const auto take = [row, &value](const std::string& text) {
    value = text == row.word_of_zero ? 0 : std::stoi(text == row.word_of_none ? "0" : text);
    if (text == row.word_of_none) value.reset();
  };
  return program.add_option_function<std::string>(name_of(row.setting), take, help)
      ->check(validator_with_words(row))
      ->default_str(setting_text(row, value));
}

}  // namespace

void add_setting_flags(CLI::App& program, SettingGroup group, RunSettings& settings) {
  visit_fields(
      [&](const char*, auto& value, const SettingRow& row) {
        if (row.group != group) return;
        CLI::Option* option = add_flag(program, row, std::string(row.help), value);
        if (!row.value.empty()) option->type_name(std::string(row.value));
      },
      settings);
}

std::set<Setting> chosen_settings(const CLI::App& program) {
  std::set<Setting> chosen;
  const RunSettings any;
  visit_fields(
      [&](const char*, const auto&, const SettingRow& row) {
        if (program.get_option(name_of(row.setting))->count() > 0) chosen.insert(row.setting);
      },
      any);
  return chosen;
}

}  // namespace beadswim
