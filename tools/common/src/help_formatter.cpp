#include "help_formatter.hpp"

#include <sstream>

namespace beadswim {
namespace {

constexpr std::size_t line_width = 100;

/// Words of `text` in lines of line_width, each after `indent` spaces.
std::string wrapped(const std::string& text, std::size_t indent) {
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

}  // namespace

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  std::string text = "  " + make_option_name(option, is_positional);
  text = text.substr(0, text.find('{'));  // what CLI11 adds to a flag that says no
  const bool takes_value = option->get_items_expected_max() != 0;
  if (takes_value && !is_positional) text += " " + option->get_type_name();
  std::string meaning = option->get_description();
  if (takes_value && !option->get_default_str().empty()) {
    meaning += " (default: " + option->get_default_str() + ")";
  }
  if (option->get_required()) meaning += " (required)";
  return text + "\n" + wrapped(meaning, 8);
}

std::string HelpFormatter::make_description(const CLI::App* program) const {
  return wrapped(program->get_description(), 0);
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return "  " + command->get_name() + "\n" + wrapped(command->get_description(), 8);
}

}  // namespace beadswim
