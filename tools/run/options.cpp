#include "options.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "beadswim/tools/named_flags.hpp"
#include "setting_flags.hpp"

namespace beadswim {
namespace {

void add_model(CLI::App& program, RunOptions& options) {
  begin_group(program, "Model");
  add_setting_flags(program, SettingGroup::model, options.settings);
  program.get_option("--model")->default_str("lbm; auto with --plan or --tolerance");
  program.add_flag(
      "--plan", options.plan,
      "Run nothing; print the expected error and cost of all possible runs, and the cheapest run within "
      "--tolerance. If you give --tolerance and no run is within it, the exit status is 2.");
  program
      .add_option("--tolerance", options.tolerance,
                  "Largest relative error of velocity and arm amplitudes for --plan and --model auto [1]")
      ->type_name("E")
      ->check(finite_positive())
      ->default_str("0.03");
}

void add_stops(CLI::App& program, RunOptions& options) {
  begin_group(program, "Checkpoints and restart");
  add_setting_flags(program, SettingGroup::checkpoints, options.settings);
  program
      .add_option("--restart", options.restart,
                  "Checkpoint, or trajectory whose last checkpoint is used, from which the run continues. "
                  "Only --cycles (total), outputs and ranks may change")
      ->type_name("FILE.h5md|FILE.h5md.ckpt.N")
      ->default_str("");
  program
      .add_option("--time-limit", options.time_limit,
                  "Wall time after which the run stops, writes its results and a checkpoint, and ends with "
                  "exit status 4. The signals SIGINT, SIGTERM and SIGUSR1 have the same effect [s]")
      ->type_name("S")
      ->check(finite_positive())
      ->default_str("none");
}

void add_outputs(CLI::App& program, RunOptions& options) {
  begin_group(program, "Output");
  add_setting_flags(program, SettingGroup::output, options.settings);
  program
      .add_option("--ranks-per-run", options.ranks_per_run,
                  "Number of ranks that run one layout of a stream together; several layouts run at the same "
                  "time")
      ->type_name("N")
      ->check(whole_number(1, 10000000))
      ->default_str("as few as keep all ranks busy");
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
  program
      .add_option("-o,--output", options.output,
                  "Trajectory file to write (H5MD); an existing file is replaced when the run ends. Required "
                  "without --restart. In the name, {} is the number of the layout of a stream")
      ->type_name("FILE.h5md")
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
              "mpirun -n 2 beadswim-run layout.json --cells-per-radius 2 --cycles 1 -o lbm.h5md >lbm.json"},
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
    throw InputError("--output", fmt::format("the file {} cannot be created: {}; give a shorter name",
                                             longest, fault.message()));
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
