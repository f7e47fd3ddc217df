#pragma once

#include <functional>

#include "beadswim/core/names.hpp"
#include "beadswim/tools/program.hpp"

// Flags whose values are words. CLI11's transformers would replace the word in the results, from which
// provenance is written, by the enumerator's number; so the word is checked, and then converted.

namespace beadswim {

/// Adds a flag that takes one of `words`; an empty `initial` is not shown as its default.
CLI::Option* add_word(CLI::App& command, const std::string& flag, const std::vector<std::string>& words,
                      const std::string& initial, const std::string& help,
                      const std::function<void(const std::string&)>& take);

/// Adds a flag that takes the name of a value. The variable's value is the default.
template <NamedEnum Enum>
CLI::Option* add_choice(CLI::App& command, const std::string& flag, Enum& value, const std::string& help) {
  return add_word(command, flag, all_names<Enum>(), to_text(value), help,
                  [&value](const std::string& word) { value = from_text<Enum>(word); });
}

/// The same without a default.
template <NamedEnum Enum>
CLI::Option* add_choice(CLI::App& command, const std::string& flag, std::optional<Enum>& value,
                        const std::string& help) {
  return add_word(command, flag, all_names<Enum>(), "", help,
                  [&value](const std::string& word) { value = from_text<Enum>(word); });
}

/// Adds a flag that takes names joined by commas. The variable's values are the default.
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
      ->check(one_of(all_names<Enum>()))
      ->default_str(CLI::detail::join(initial, ","))
      ->type_name("NAME,...");
}

/// Adds a flag that users look for and that does not exist; help omits it. A command line with it throws
/// InputError with this explanation.
void add_absent_flag(CLI::App& command, const std::string& names, const std::string& explanation);

/// Adds a flag that takes on or off.
CLI::Option* add_switch(CLI::App& command, const std::string& flag, bool& is_on, const std::string& help);
std::string on_or_off(bool is_on);

}  // namespace beadswim
