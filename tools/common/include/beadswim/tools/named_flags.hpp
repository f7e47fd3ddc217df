#pragma once

#include <concepts>
#include <functional>

#include "beadswim/core/names.hpp"
#include "beadswim/tools/program.hpp"

// Flags of all kinds of values. A word is checked first and then converted to an enumerator. The transformers
// of CLI11 are not used, because they would replace the word by a number in the recorded command line.

namespace beadswim {

/// Value of a flag.
struct FlagValue {
  std::string name{};                       ///< in the help, for example "X,Y,Z"
  std::optional<CLI::Validator> allowed{};  ///< nullopt: every text
  std::string initial{};                    ///< default in the help; empty: that of the variable
};

/// Adds a flag. Parsing it stores the value in `target`, or passes its text to the function `target`.
template <class Target>
CLI::Option* add_value(CLI::App& command, const std::string& flag, Target&& target, const FlagValue& value,
                       const std::string& help) {
  CLI::Option* option = nullptr;
  if constexpr (std::invocable<Target, const std::string&>) {
    option = command.add_option_function<std::string>(flag, target, help);
  } else {
    option = command.add_option(flag, target, help);
  }
  if (value.allowed) option->check(*value.allowed);
  if (!value.initial.empty()) option->default_str(value.initial);
  return option->type_name(value.name);
}

/// Adds a flag whose value is a list of numbers joined by commas, as number_list() accepts it.
template <class Number>
CLI::Option* add_list(CLI::App& command, const std::string& flag, std::vector<Number>& numbers,
                      const FlagValue& value, const std::string& help) {
  const auto take = [&numbers](const std::string& text) {
    const std::vector<double> parsed = parse_numbers(text);
    numbers.assign(parsed.begin(), parsed.end());
  };
  return add_value(command, flag, take, value, help);
}

/// Adds a flag whose value is an angle in radian, or in degrees with the ending deg.
template <class Angle>
CLI::Option* add_angle(CLI::App& command, const std::string& flag, Angle& radians, const FlagValue& value,
                       const std::string& help) {
  return add_value(
      command, flag, [&radians](const std::string& text) { radians = parse_angle(text); }, value, help);
}

/// Adds a flag whose value is one of `words`. Parsing the flag calls take(word). The help shows `initial` as
/// the default, unless `initial` is empty.
CLI::Option* add_word(CLI::App& command, const std::string& flag, const std::vector<std::string>& words,
                      const std::string& initial, const std::string& help,
                      const std::function<void(const std::string&)>& take);

/// Adds a flag whose value is the name of an enumerator. Parsing the flag stores the enumerator in `value`,
/// whose initial contents are the default; an optional without value has no default.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& flag, Value& value, const std::string& help) {
  using Enum = std::remove_cvref_t<decltype(*std::optional(value))>;
  const std::optional<Enum> initial = value;
  return add_word(command, flag, all_names<Enum>(), initial ? to_text(*initial) : "", help,
                  [&value](const std::string& word) { value = from_text<Enum>(word); });
}

/// Adds a flag whose value is a list of names of enumerators, joined by commas. Parsing the flag stores the
/// enumerators in `values`, whose initial contents are the default.
template <NamedEnum Enum>
CLI::Option* add_choices(CLI::App& command, const std::string& flag, std::vector<Enum>& values,
                         const std::string& help) {
  std::vector<std::string> initial;
  for (const Enum value : values) initial.push_back(to_text(value));
  const std::function<void(const std::vector<std::string>&)> take =
      [&values](const std::vector<std::string>& words) {
        values.clear();
        for (const std::string& word : words) values.push_back(from_text<Enum>(word));
      };
  return command.add_option_function(flag, take, help)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(all_names<Enum>()))
      ->default_str(CLI::detail::join(initial, ","))
      ->type_name("NAME,...");
}

/// Adds a flag that does not exist, but that users may look for. The help does not list this flag. If the
/// command line contains the flag, the parser throws InputError with the explanation. `names`: names of the
/// flag, joined by commas.
void add_absent_flag(CLI::App& command, const std::string& names, const std::string& explanation);

/// Adds a flag whose value is on or off. The initial value of `is_on` is the default.
CLI::Option* add_switch(CLI::App& command, const std::string& flag, bool& is_on, const std::string& help);

}  // namespace beadswim
