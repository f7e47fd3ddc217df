#include "options.hpp"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "beadswim/tools/named_flags.hpp"

namespace beadswim {
namespace {

/// Returns the validator of a number with decimals.
CLI::Validator validator_of(const SettingRow& row) {
  if (std::isfinite(row.high)) return number_between(row.low, row.high);
  if (row.allows_low) return finite_non_negative();
  if (row.too_low.empty()) return finite_positive();
  const auto fault = [row](const std::string& text) {
    std::string why = finite_positive()(text);
    if (!why.empty() || std::stod(text) > row.low) return why;
    return fmt::format("the {} {} is not above {}, so {}", words_of(row.setting), text, row.low, row.too_low);
  };
  return CLI::Validator(fault, "");
}

CLI::Validator whole_validator(const SettingRow& row) {
  return whole_number(std::llround(row.low), std::llround(row.high));
}

/// Returns the validator of a whole number, of the word for 0 and of the word for no value.
CLI::Validator validator_with_words(const SettingRow& row) {
  const auto fault = [row](const std::string& text) -> std::string {
    if (text == row.word_of_zero || text == row.word_of_none || whole_validator(row)(text).empty()) return {};
    return fmt::format("use {}, {}, or a whole number from {} to {}", row.word_of_zero, row.word_of_none,
                       row.low, row.high);
  };
  return CLI::Validator(fault, "");
}

template <class T>
CLI::Option* add_flag(CLI::App& program, const SettingRow& row, T& value) {
  const std::string name = name_of(row.setting),
                    help(row.help);  // the help ends with the unit, if there is one
  if constexpr (NamedEnum<T>) {
    return add_choice(program, name, value, help);
  } else if constexpr (std::same_as<T, bool>) {
    return add_switch(program, name, value, help);
  } else if constexpr (std::same_as<T, std::string>) {
    const auto fault = [](const std::string& text) {
      return text.empty() ? std::string("the value is empty; give one") : std::string();
    };
    return program.add_option(name, value, help)
        ->check(CLI::Validator(fault, ""))
        ->default_str(std::string(value.empty() ? row.unset : value));
  } else {
    if (!row.word_of_zero.empty()) {
      const auto take = [row, &value](const std::string& text) {
        value = text == row.word_of_zero ? 0 : std::stoi(text == row.word_of_none ? "0" : text);
        if constexpr (is_optional<T>)
          if (text == row.word_of_none) value.reset();
      };
      return program.add_option_function<std::string>(name, take, help)
          ->check(validator_with_words(row))
          ->default_str(setting_text(row, value));
    }
    constexpr bool is_whole = std::same_as<T, int> || std::same_as<T, std::optional<int>>;
    CLI::Option* option =
        program.add_option(name, value, help)->check(is_whole ? whole_validator(row) : validator_of(row));
    return is_optional<T> ? option->default_str(std::string(row.unset)) : option;
  }
}

/// Adds the flags of the settings of one group to the program: names, help, defaults and allowed values
/// follow from the table of settings. Parsing a flag stores its value in `settings`.
void add_setting_flags(CLI::App& program, SettingGroup group, RunSettings& settings) {
  visit_fields(
      [&](const char*, auto& value, const SettingRow& row) {
        if (row.group != group) return;
        CLI::Option* option = add_flag(program, row, value);
        if (!row.value.empty()) option->type_name(std::string(row.value));
      },
      settings);
}

/// Returns the settings whose flags are on the command line, after parsing.
std::set<Setting> chosen_settings(const CLI::App& program) {
  std::set<Setting> chosen;
  const RunSettings any;
  visit_fields(
      [&](const char*, const auto&, const SettingRow& row) {
        if (program.get_option(name_of(row.setting))->count() > 0) chosen.insert(row.setting);
      },
      any);
  return chosen;
}

void add_model(CLI::App& program, RunOptions& options) {
  begin_group(program, "Model");
  add_setting_flags(program, SettingGroup::model, options.settings);
  program.get_option("--model")->default_str("lbm; auto with --plan or --tolerance");
  program.add_flag(
      "--plan", options.plan,
      "Run nothing; print the expected error and cost of all possible runs, and the cheapest run within "
      "--tolerance. If you give --tolerance and no run is within it, the exit status is 2.");
  add_value(program, "--tolerance", options.tolerance, {"E", finite_positive(), "0.03"},
            "Largest relative error of velocity and arm amplitudes for --plan and --model auto [1]");
}

void add_stops(CLI::App& program, RunOptions& options) {
  begin_group(program, "Checkpoints and restart");
  add_setting_flags(program, SettingGroup::checkpoints, options.settings);
  add_value(program, "--restart", options.restart, {.name = "FILE.h5md|FILE.h5md.ckpt.N"},
            "Checkpoint, or trajectory whose last checkpoint is used, from which the run continues. Only "
            "--cycles (total), outputs and ranks may change")
      ->default_str("");
  add_value(program, "--time-limit", options.time_limit, {"S", finite_positive(), "none"},
            "Wall time after which the run stops, writes its results and a checkpoint, and ends with exit "
            "status 4. The signals SIGINT, SIGTERM and SIGUSR1 have the same effect [s]");
}

void add_outputs(CLI::App& program, RunOptions& options) {
  begin_group(program, "Output");
  add_setting_flags(program, SettingGroup::output, options.settings);
  add_value(program, "--ranks-per-run", options.ranks_per_run,
            {"N", whole_number(1, 10000000), "as few as keep all ranks busy"},
            "Number of ranks that run one layout of a stream together; several layouts run at the same time");
  add_choice(program, "--progress", options.progress,
             "Form of the progress messages on standard error; auto is bar on a terminal, otherwise lines. "
             "All except bar are printed every 10 s");
  program.add_flag("!--no-provenance", options.with_provenance,
                   "Omit cost and provenance from the run record, so that equal runs give equal bytes.");
}

/// Adds all flags to the program. The provenance record lists the flags in this order.
void add_flags(CLI::App& program, RunOptions& options) {
  program.add_option("LAYOUT", options.layouts, "Layout files (JSON, JSON Lines); - is standard input.")
      ->default_str("-");
  begin_group(program, "Output");
  add_value(program, "-o,--output", options.output, {.name = "FILE.h5md"},
            "Trajectory file to write (H5MD); an existing file is replaced when the run ends. Required "
            "without --restart. In the name, {} is the number of the layout of a stream")
      ->default_str("");
  add_model(program, options);
  begin_group(program, "Length and sampling");
  add_setting_flags(program, SettingGroup::length, options.settings);
  begin_group(program, "Lattice (model lbm)");
  add_setting_flags(program, SettingGroup::lattice, options.settings);
  add_stops(program, options);
  add_outputs(program, options);
  set_footer(program,
             {"beadswim-run layout.json --model rpy -o run.h5md >run.json",
              "mpirun -n 2 beadswim-run layout.json --cells-per-radius 2 --cycles 1 --flow-every 1 -o "
              "lbm.h5md >lbm.json"},
             "choosing-a-model.md");
}

constexpr const char* restart_keeps_model =
    "the flag chooses the model at the start of a run, and a restart continues with its model and settings; "
    "leave the flag out";

/// Throws InputError if --tolerance has no effect.
void require_tolerance_applies(const RunOptions& options) {
  if (!options.tolerance || options.plan || options.settings.model == RunModel::automatic) return;
  if (!options.restart.empty()) throw InputError("--tolerance", restart_keeps_model);
  throw InputError("--tolerance",
                   "the flag applies to --plan and --model auto only; leave it out, or use --sum-tolerance");
}

/// Throws InputError if the names of the files that the run writes beside the trajectory would be too long.
void require_short_name(const std::string& output) {
  const std::string longest = output + ".ckpt.0.tmp4194304_cid-4194304-4194304.sm";  // by Open MPI
  std::error_code fault;
  if (!std::filesystem::exists(longest, fault) && fault == std::errc::filename_too_long)
    throw InputError("--output", "the file {} cannot be created: {}; give a shorter name", longest,
                     fault.message());
}

}  // namespace

std::variant<RunOptions, int> parse_run_options(int argc, const char* const* argv,
                                                const std::optional<RunSettings>& defaults) {
  const auto program = make_program(
      "beadswim-run",
      "Simulates the swimmers of a layout in a lattice-Boltzmann fluid, or with a mobility (fluid without "
      "inertia). Writes the trajectory of the beads (H5MD) and prints the run record (JSON) with velocity "
      "and stroke of each cycle. Use mpirun -n N to run on N ranks.");
  RunOptions options;
  if (defaults) options.settings = *defaults;
  add_flags(*program, options);
  if (const auto status = parse_command_line(*program, argc, argv)) return *status;
  options.chosen = chosen_settings(*program);
  options.names_layouts = program->get_option("LAYOUT")->count() > 0;
  if (options.output.empty() && options.restart.empty() && !options.plan)
    throw InputError("--output", "the flag is missing; name the trajectory to write with -o FILE.h5md");
  require_short_name(options.output);
  const bool is_model_given = options.chosen.contains(Setting::model) || defaults.has_value();
  if (!is_model_given && (options.plan || options.tolerance)) options.settings.model = RunModel::automatic;
  if (options.settings.model == RunModel::automatic && is_model_given && !options.restart.empty())
    throw InputError("--model", restart_keeps_model);
  require_tolerance_applies(options);
  options.provenance = provenance_record(*program);
  return options;
}

}  // namespace beadswim
