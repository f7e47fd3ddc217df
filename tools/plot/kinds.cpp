#include "kinds.hpp"

namespace beadswim {

CLI::Validator id_or_frame_number() {
  return whole_number(0, 999999999);
}

void add_method_flag(CLI::App& command, InputChoice& choice) {
  add_value(command, "--method", choice.methods, {.name = "NAME,...", .initial = "the best usable method"},
            "Theory methods whose predictions are drawn, in this order, or all")
      ->delimiter(',');
}

void add_result_flags(CLI::App& command, InputChoice& choice) {
  add_method_flag(command, choice);
  const auto take_cycle = [&choice](const std::string& text) { choice.cycle = parse_cycle_choice(text); };
  add_value(command, "--cycle", take_cycle, {.name = "last|N|mean:N", .initial = "last"},
            "Driving cycle of each run that is drawn: the last, cycle number N (the first is 1), or the mean "
            "over the last N cycles");
}

void add_swimmers(CLI::App& command, std::vector<int>& ids, const std::string& name,
                  const std::string& initial, const std::string& help) {
  add_list(command, "--swimmers", ids, {name, number_list({}, id_or_frame_number()), initial}, help);
}

}  // namespace beadswim
