#include "kinds.hpp"

namespace beadswim {

CLI::Validator id_or_frame_number() {
  return whole_number(0, 999999999);
}

void add_result_flags(CLI::App& command, InputChoice& choice) {
  command
      .add_option("--method", choice.methods,
                  "Theory methods whose predictions are drawn, in this order, or all")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->default_str("the best usable method");
  command
      .add_option_function<std::string>(
          "--cycle", [&choice](const std::string& text) { choice.cycle = parse_cycle_choice(text); },
          "Driving cycle of each run that is drawn: the last, cycle number N (the first is 1), or "
          "the mean over the last N cycles")
      ->type_name("last|N|mean:N")
      ->default_str("last");
}

CLI::Option* add_whole_numbers(CLI::App& command, const std::string& flag, std::vector<int>& numbers,
                               const CLI::Validator& check, const std::string& help) {
  return command
      .add_option_function<std::string>(
          flag, [&numbers](const std::string& text) { numbers = parse_whole_numbers(text); }, help)
      ->check(check);
}

CLI::Option* add_swimmers(CLI::App& command, std::vector<int>& ids, const std::string& help) {
  return add_whole_numbers(command, "--swimmers", ids, number_list({}, id_or_frame_number()), help)
      ->type_name("ID,...");
}

}  // namespace beadswim
