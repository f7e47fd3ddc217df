#include "beadswim/tools/program.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/core/version.hpp"

namespace beadswim {
namespace {

/// Flags that are not the words of the setting with hyphens.
const std::map<Setting, std::string> special_flags{
    {Setting::free_quantity, "--free"},
    {Setting::limit, "--subject-to"},
    {Setting::output, "-o"},
    {Setting::ranks, "mpirun -n"},
    {Setting::refinement, "--refine"},
    {Setting::stroke_record, "--stroke-from"},
    {Setting::unbounded, "beadswim-layout swimmer --unbounded"},
    {Setting::verification, "--verify-by"},
};

/// Returns the flag with which users set this setting of the libraries, for error messages.
std::string flag_of(Setting setting) {
  const auto special = special_flags.find(setting);
  if (special != special_flags.end()) return special->second;
  std::string flag = "--" + words_of(setting);
  std::ranges::replace(flag, ' ', '-');
  return flag;
}

/// Returns the command that the command line names, for example the command "swimmer" of "beadswim-layout
/// swimmer". Returns the program if the command line names no command.
const CLI::App& chosen_command(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? program : chosen_command(*chosen.back());
}

/// Returns the long names, without dashes, of all flags that the help of the command lists.
std::vector<std::string> long_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

bool looks_like_flag(const std::string& argument) {
  const bool is_negative_number = argument.size() > 1 && argument[1] >= '0' && argument[1] <= '9';
  return argument.size() > 1 && argument[0] == '-' && !is_negative_number;
}

/// Returns the names of all other commands of this program that have a flag with the name `word`.
std::vector<std::string> others_with_flag(const std::string& word, const CLI::App& command) {
  std::vector<std::string> names;
  if (command.get_parent() == nullptr) return names;
  for (const CLI::App* other : command.get_parent()->get_subcommands({}))
    if (std::ranges::count(long_names(*other), word) > 0) names.push_back(other->get_name());
  return names;
}

[[noreturn]] void refuse_flag(const std::string& flag, const CLI::App& command) {
  const std::string name = flag.substr(0, flag.find('='));
  const std::string word = name.substr(std::min(name.find_first_not_of('-'), name.size()));
  const std::vector<std::string> known = long_names(command);
  if (std::ranges::find(known, word) != known.end())
    throw InputError(name, "the flag is in the wrong place; write the flag after \"{}\"", full_name(command));
  if (const auto others = others_with_flag(word, command); !others.empty()) {
    throw InputError(
        name,
        "the command \"{}\" does not have this flag; only these commands have the flag: {}; remove the flag",
        command.get_name(), joined(others, ", "));
  }
  const std::string nearest = nearest_name(word, known);
  throw InputError(name, "unknown flag{} \"{} --help\" lists all flags",
                   nearest.empty() ? "." : "; did you mean --" + nearest + "?", full_name(command));
}

/// Throws InputError if the command line contains an argument that the parser could not use. The message
/// reports the first unknown flag; without an unknown flag, it reports the first such argument.
void refuse_leftovers(const CLI::App& program) {
  const CLI::App& command = chosen_command(program);
  const std::vector<std::string> leftovers = program.remaining(true);
  const std::vector<std::string> commands = command_names(command);
  const auto flag = std::find_if(leftovers.begin(), leftovers.end(), looks_like_flag),
             word = std::find_if_not(leftovers.begin(), leftovers.end(), looks_like_flag);
  const bool lacks_command = !commands.empty() && word != leftovers.end();
  if (flag != leftovers.end() && !lacks_command) refuse_flag(*flag, command);
  if (leftovers.empty()) return;
  if (word->empty()) throw InputError("command line", "an argument is empty; is a shell variable not set?");
  if (lacks_command)
    throw InputError(*word, "unknown command{} One of these must come first: {}",
                     format_suggestion(*word, commands), joined(commands, ", "));
  throw InputError(*word, "unexpected argument{}. \"{} --help\" lists what is allowed",
                   finite()(split_at_commas(*word).front()).empty()
                       ? "; join the numbers of one flag by commas, without spaces"
                       : "",
                   full_name(command));
}

/// Throws InputError if a flag is given twice or without its value.
void refuse_wrong_counts(const CLI::App& command, const CLI::ArgumentMismatch& error) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (!std::string(error.what()).starts_with(name + ":")) continue;
    throw InputError(name,
                     option->count() > 1
                         ? fmt::format("the flag is given {} times; give the flag only once", option->count())
                         : fmt::format("the flag needs a value: {}", option->get_type_name()));
  }
}

/// Throws InputError if a value is given for a flag that takes no value. CLI11 reports this error with a
/// message that contains "FLAG = ".
void refuse_values(const CLI::App& command, const std::string& message) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() == 0 &&
        message.find(option->get_name() + " = ") != std::string::npos)
      throw InputError(option->get_name(), "the flag takes no value; remove \"=\" and the text after it");
  }
}

/// Throws InputError if the value of a flag or the name of a file is empty. An unset shell variable usually
/// causes this.
void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (option->get_items_expected_max() != 0 && std::ranges::find(values, "") != values.end())
      throw InputError(option->get_name(), "the value is empty; is a shell variable not set?");
  }
  for (const CLI::App* chosen : command.get_subcommands()) refuse_empty_values(*chosen);
}

/// Throws InputError if a required flag or file is missing.
void refuse_absent(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    throw InputError(option->get_name(), "required but not given; see \"{} --help\"", full_name(command));
  }
}

/// Throws InputError if the command line contains two flags that exclude each other, or a flag without
/// another flag that it needs.
void refuse_combinations(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    for (const CLI::Option* other : option->get_excludes()) {
      if (other->count() == 0) continue;
      throw InputError(option->get_name(), "the flag cannot be combined with {}; remove one of the two flags",
                       other->get_name());
    }
    for (const CLI::Option* other : option->get_needs()) {
      if (other->count() > 0) continue;
      throw InputError(option->get_name(), "the flag has no effect without {0}; add {0}, or remove the flag",
                       other->get_name());
    }
  }
}

[[noreturn]] void refuse_command_line(const CLI::App& program, const CLI::ParseError& error) {
  refuse_leftovers(program);
  const CLI::App& command = chosen_command(program);
  if (const auto* mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&error)) {
    refuse_wrong_counts(command, *mismatch);
  }
  const std::string text = error.what();
  const std::size_t colon = text.find(": ");
  const bool names_flag = text.starts_with("-") && colon != std::string::npos;
  if (names_flag) throw InputError(text.substr(0, colon), text.substr(colon + 2));
  refuse_values(command, text);
  refuse_absent(command);
  refuse_combinations(command);
  const std::vector<std::string> commands = command_names(command);
  const std::string what =
      commands.empty() ? text : fmt::format("a command is needed: {}", joined(commands, ", "));
  throw InputError("command line", "{}; see \"{} --help\"", what, full_name(command));
}

/// Adds the flags of the command line with their values, in the order of the help, and the names of commands
/// to `arguments`.
void append_arguments(const CLI::App& command, Json& arguments) {
  for (const CLI::Option* option : command.get_options()) {
    const bool names_file = option->get_type_name().find("FILE") != std::string::npos;
    if (option->count() == 0 || option->get_positional() || names_file) continue;
    const std::string name = option->get_name();
    if (option->get_items_expected_max() == 0) {
      arguments.push_back(name);
    } else if (option->get_delimiter() != '\0') {
      arguments.push_back(name + "=" + CLI::detail::join(option->results(), ","));
    } else {
      for (const std::string& value : option->results()) arguments.push_back(name + "=" + value);
    }
  }
  for (const CLI::App* chosen : command.get_subcommands()) {
    arguments.push_back(chosen->get_name());
    append_arguments(*chosen, arguments);
  }
}

}  // namespace

std::unique_ptr<CLI::App> make_program(const std::string& name, const std::string& description) {
  set_setting_names(flag_of);
  auto program = std::make_unique<CLI::App>(description, name);
  program->formatter(help_formatter());
  program->set_help_flag("-h,--help", "Print this help and exit.");
  program->set_version_flag("--version", fmt::format("{} {} ({})", name, version(), revision()),
                            "Print version and revision and exit.");
  program->option_defaults()->always_capture_default();
  return program;
}

std::string full_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent ? full_name(*parent) + " " + command.get_name() : command.get_name();
}

void begin_group(CLI::App& command, const std::string& title) {
  command.option_defaults()->group(title);
}

void set_footer(CLI::App& command, const std::vector<std::string>& examples, const std::string& page) {
  std::string text = "Examples:\n";
  for (const std::string& example : examples) {
    text += "  $ " + CLI::detail::find_and_replace(example, "\n", "\n  > ") + "\n";
  }
  command.footer(text + "\nRead more: docs/" + page);
}

std::optional<int> parse_command_line(CLI::App& program, int argc, const char* const* argv) {
  if (!command_names(program).empty())
    program.set_help_all_flag("--help-all", "Print the help of all commands and exit.");
  try {
    program.parse(argc, argv);
    refuse_empty_values(program);
    return std::nullopt;
  } catch (const CLI::CallForVersion& version_text) {
    write_text("-", fmt::format("{}\n", version_text.what()));
  } catch (const CLI::CallForAllHelp&) {
    write_text("-", program.help("", CLI::AppFormatMode::All));
  } catch (const CLI::Success&) {
    // "beadswim-layout UNKNOWN --help": reports the unknown command instead of printing the help.
    const bool lacks_command = program.get_subcommands().empty() && !command_names(program).empty();
    if (lacks_command) refuse_leftovers(program);
    write_text("-", program.help());
  } catch (const CLI::ParseError& error) {
    refuse_command_line(program, error);
  }
  return static_cast<int>(ExitStatus::fine);
}

void require_csv_path(const std::string& path, const std::string& flag) {
  if (path.ends_with(".csv") || path == "-") return;
  throw InputError(
      flag,
      "the file name \"{}\" does not end in .csv; give a name with this ending, or - for standard output",
      path);
}

void require_other_file(const std::string& input, const std::string& output) {
  std::error_code not_there;
  if (input == "-" || !std::filesystem::equivalent(input, output, not_there)) return;
  throw InputError(output, "the output would replace the input file; name another output file");
}

void report_left_out(const char* program, int left_out, int documents) {
  if (left_out == documents)
    throw InputError("FILES", "all documents are failures; their key \"reason\" says why there is no result");
  if (left_out > 0)
    print_to_stderr(fmt::format("{}: {} of {} documents have no result, and are left out\n", program,
                                left_out, documents));
}

Json provenance_record(const CLI::App& program) {
  Json arguments = Json::array();
  append_arguments(program, arguments);
  return {{"program", program.get_name()},
          {"version", version()},
          {"revision", revision()},
          {"arguments", arguments}};
}

}  // namespace beadswim
