#include "flags.hpp"

#include <fmt/core.h>

namespace beadswim {
namespace {

CLI::Validator last_or_whole_number() {
  const auto fault = [](const std::string& text) {
    return text == "last" || id_or_frame_number()(text).empty()
               ? std::string{}
               : fmt::format("\"{}\": the frame must be \"last\" or a whole number, 0 or greater", text);
  };
  return CLI::Validator(fault, "");
}

/// Parses a mark NAME=ID, such as "A=3". Throws InputError if the text has another form.
SwimmerMark parse_mark(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  const std::string id = sign == std::string::npos ? "" : text.substr(sign + 1);
  if (sign == 0 || !id_or_frame_number()(id).empty())
    throw InputError("--mark",
                     fmt::format("\"{}\": the value must be a label and a swimmer's id, such as A=3", text));
  return {text.substr(0, sign), std::stoi(id)};
}

}  // namespace

CLI::Validator id_or_frame_number() {
  return whole_number(0, 999999999);
}

void add_result_flags(CLI::App& command, ResultFlags& flags) {
  command
      .add_option("--method", flags.methods.methods,
                  "Theory methods whose predictions are drawn, in this order, or all")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->default_str("the best usable method");
  command
      .add_option("--cycle", flags.cycle,
                  "Driving cycle of each run that is drawn: the last, cycle number N (the first is 1), or "
                  "the mean over the last N cycles")
      ->type_name("last|N|mean:N");
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

void add_frame(CLI::App& command, std::optional<std::size_t>& frame) {
  command
      .add_option_function<std::string>(
          "--frame",
          [&frame](const std::string& text) {
            frame.reset();
            if (text != "last") frame = std::stoul(text);
          },
          "Number of the trajectory frame to draw, counted from 0")
      ->type_name("last|N")
      ->check(last_or_whole_number())
      ->default_str("last");
}

void add_marks(CLI::App& command, std::vector<SwimmerMark>& marks) {
  command
      .add_option_function<std::vector<std::string>>(
          "--mark",
          [&marks](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) marks.push_back(parse_mark(text));
          },
          "Names to write beside swimmers, each with the id of its swimmer, for example A=3.")
      ->type_name("NAME=ID,...")
      ->delimiter(',')
      ->default_str("none");
}

}  // namespace beadswim
