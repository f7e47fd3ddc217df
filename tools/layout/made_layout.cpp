#include "made_layout.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/joined.hpp"
#include "beadswim/tools/program.hpp"
#include "commands.hpp"

namespace beadswim {
namespace {

/// The program with only the commands that make layouts.
struct Makers {
  std::unique_ptr<CLI::App> program = make_program("beadswim-layout", "");
  std::vector<Command> commands{add_swimmer_command(*program), add_swarm_command(*program),
                                add_shape_command(*program)};
};

/// Calls visit(command, name) for the commands without further commands, with names such as "shape triangle".
void visit_leaves(const CLI::App& command, const std::string& name, const auto& visit) {
  const auto children = command.get_subcommands([](const CLI::App*) { return true; });
  if (children.empty()) visit(command, name);
  for (const CLI::App* child : children)
    visit_leaves(*child, name.empty() ? child->get_name() : name + " " + child->get_name(), visit);
}

/// Returns true for a flag that describes the layout.
bool is_parameter(const CLI::Option& option) {
  const auto& names = option.get_lnames();
  return !names.empty() && !option.get_group().empty() && names.front() != "help" &&
         names.front() != "help-all" && names.front() != "jsonl";
}

/// Returns the numbers of a text, angles in radian, or the text.
Json typed(const std::string& text) {
  const std::vector<std::string> parts = split_at_commas(text);
  if (!std::ranges::all_of(parts, [](const std::string& part) { return angle()(part).empty(); })) return text;
  Json numbers = Json::array();
  for (const std::string& part : parts) numbers.push_back(parse_angle(part));
  return numbers.size() == 1 ? numbers.front() : numbers;
}

/// Returns the text of a flag with this value: the inverse of typed().
std::string flag_text(const std::string& name, const Json& value) {
  const auto text = [](const Json& part) {
    return part.is_number()   ? fmt::format("{}", part.get<double>())
           : part.is_string() ? part.get<std::string>()
                              : part.dump();
  };
  if (value == true) return "--" + name;
  if (!value.is_array()) return "--" + name + "=" + text(value);
  std::vector<std::string> parts;
  for (const Json& part : value) parts.push_back(text(part));
  return "--" + name + "=" + joined(parts, ",");
}

}  // namespace

Json made_by_record(const CLI::App& program) {
  std::string name;
  const CLI::App* command = &program;
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    name += (name.empty() ? "" : " ") + command->get_name();
  }
  Json parameters = Json::object();
  for (const CLI::Option* option : command->get_options()) {
    if (option->count() == 0 || !is_parameter(*option)) continue;
    parameters[option->get_lnames().front()] =
        option->get_items_expected_max() == 0 ? Json(true) : typed(option->results().front());
  }
  return {{"command", name}, {"parameters", parameters}};
}

std::set<std::string> parameter_names(const std::string& command) {
  std::set<std::string> names;
  const Makers makers;
  visit_leaves(*makers.program, "", [&](const CLI::App& leaf, const std::string& name) {
    if (!command.empty() && name != command) return;
    for (const CLI::Option* option : leaf.get_options())
      if (is_parameter(*option)) names.insert(option->get_lnames().front());
  });
  return names;
}

MadeLayout made_layout(const Json& made_by, const std::string& source) {
  const std::string command = made_by["command"];
  const std::set<std::string> known = parameter_names(command);
  std::vector<std::string> arguments{"beadswim-layout"};
  for (const std::string& word : split_at(' ', command)) arguments.push_back(word);
  for (const auto& [name, value] : made_by["parameters"].items()) {
    if (!known.contains(name))
      throw InputError(source + ":/made_by", "\"{}\" has no flag --{}; remove the key made_by", command,
                       name);
    arguments.push_back(flag_text(name, value));
  }
  std::vector<const char*> words;
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  const Makers makers;
  parse_command_line(*makers.program, static_cast<int>(words.size()), words.data());
  for (const Command& maker : makers.commands)
    if (maker.flags->parsed()) return {.layout = maker.make(), .made_by = made_by_record(*makers.program)};
  throw InputError(source + ":/made_by/command",
                   "there is no command \"{}\" that makes layouts; remove the key made_by", command);
}

}  // namespace beadswim
