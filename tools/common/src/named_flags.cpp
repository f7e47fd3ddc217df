#include "beadswim/tools/named_flags.hpp"

#include "beadswim/core/joined.hpp"

namespace beadswim {

CLI::Option* add_word(CLI::App& command, const std::string& flag, const std::vector<std::string>& words,
                      const std::string& initial, const std::string& help,
                      const std::function<void(const std::string&)>& take) {
  return command.add_option_function(flag, take, help)
      ->run_callback_for_default()  // --restart sets values from the checkpoint with default_val()
      ->check(one_of(words))
      ->type_name(joined(words, "|"))
      ->default_str(initial);
}

void add_absent_flag(CLI::App& command, const std::string& names, const std::string& explanation) {
  const std::string first = names.substr(0, names.find(','));
  const std::function<void(const std::vector<std::string>&)> refuse =
      [first, explanation](const std::vector<std::string>&) { throw InputError(first, explanation); };
  command.add_option_function(names, refuse)->expected(0, 1)->group("");
}

CLI::Option* add_switch(CLI::App& command, const std::string& flag, bool& is_on, const std::string& help) {
  return add_word(command, flag, {"on", "off"}, is_on ? "on" : "off", help,
                  [&is_on](const std::string& word) { is_on = word == "on"; });
}

}  // namespace beadswim
