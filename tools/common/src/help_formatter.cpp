#include <sstream>

#include "beadswim/tools/program.hpp"

namespace beadswim {

std::string wrapped(const std::string& text, std::size_t indent) {
  constexpr std::size_t line_width = 100;
  std::istringstream words(text);
  std::string lines;
  std::string line(indent, ' ');
  for (std::string word; words >> word;) {
    const bool is_first = line.size() == indent;
    if (!is_first && line.size() + 1 + word.size() > line_width) {
      lines += line + "\n";
      line.assign(indent, ' ');
    }
    if (line.size() > indent) line += ' ';
    line += word;
  }
  return lines + line + "\n";
}

namespace {

/// Splits a flag's description of the form "sentence [unit]" into sentence and unit.
std::pair<std::string, std::string> split_off_unit(const std::string& description) {
  const std::size_t start = description.rfind(" [");
  if (!description.ends_with("]") || start == std::string::npos) return {description, ""};
  return {description.substr(0, start), description.substr(start + 2, description.size() - start - 3)};
}

/// Returns the text " [unit; default: value; required]" for the help of a flag. Omits the parts that the flag
/// does not have.
std::string format_properties(const CLI::Option& option, const std::string& unit) {
  std::vector<std::string> parts;
  if (!unit.empty()) parts.push_back(unit);
  const bool takes_value = option.get_items_expected_max() != 0;
  if (takes_value && !option.get_required() && !option.get_default_str().empty())
    parts.push_back("default: " + option.get_default_str());
  if (option.get_required()) parts.emplace_back("required");
  return parts.empty() ? "" : " [" + CLI::detail::join(parts, "; ") + "]";
}

/// Formats the help of a program. The first line of each flag contains its name and the type of its value.
/// The next lines contain its description, followed by unit, default and "required" in brackets. If a flag
/// has a unit, the description that is passed to CLI11 must end with the unit in brackets.
///
/// The program help2man converts the output of --help-all to a manual page. A heading *command* begins a
/// section of this page. Lines that begin with $ are examples, which form one section for all commands.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    std::string text = "  " + make_option_name(option, is_positional);
    text = text.substr(0, text.find('{'));  // CLI11 appends "{false}" to a flag that sets false
    const bool takes_value = option->get_items_expected_max() != 0;
    if (takes_value && !is_positional) text += " " + option->get_type_name();
    const auto [sentence, unit] = split_off_unit(option->get_description());
    const char* const stop = sentence.ends_with(".") ? "" : ".";
    return text + "\n" + wrapped(sentence + stop + format_properties(*option, unit), 8);
  }

  std::string make_help(const CLI::App* program, std::string name, CLI::AppFormatMode mode) const override {
    if (mode == CLI::AppFormatMode::Sub) return make_expanded(program);
    return make_description(program) + make_usage(program, name) + make_positionals(program) +
           make_flag_groups(program, mode) + make_subcommands(program, mode) + "\n" + make_footer(program);
  }

  std::string make_description(const CLI::App* program) const override {
    return wrapped(program->get_description(), 0);
  }

  std::string make_subcommand(const CLI::App* command) const override {
    return "  " + command->get_name() + "\n" + wrapped(command->get_description(), 8);
  }

  std::string make_subcommands(const CLI::App* program, CLI::AppFormatMode mode) const override {
    if (mode != CLI::AppFormatMode::All) return CLI::Formatter::make_subcommands(program, mode);
    std::string text;
    for (const CLI::App* command : program->get_subcommands({})) text += make_expanded(command);
    return text;
  }

  std::string make_expanded(const CLI::App* command) const override {
    return "\n*" + full_name(*command) + "*\n\n" + make_description(command) + make_positionals(command) +
           make_flag_groups(command, CLI::AppFormatMode::Sub) +
           make_subcommands(command, CLI::AppFormatMode::All) + "\n" + make_footer(command);
  }

 private:
  std::string make_flag_groups(const CLI::App* program, CLI::AppFormatMode mode) const {
    std::string text;
    for (const std::string& group : program->get_groups()) {
      const bool is_whole_page = mode != CLI::AppFormatMode::Sub;
      const std::vector<const CLI::Option*> options = program->get_options([&](const CLI::Option* option) {
        const bool is_help = option == program->get_help_ptr() || option == program->get_help_all_ptr();
        return option->get_group() == group && option->nonpositional() && (is_whole_page || !is_help);
      });
      const std::string title = !is_whole_page && group == "Options" ? "Flags" : group;
      if (!group.empty() && !options.empty()) text += make_group(title, false, options);
    }
    return text;
  }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter() {
  return std::make_shared<HelpFormatter>();
}

}  // namespace beadswim
