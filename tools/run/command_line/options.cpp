#include "command_line/options.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "beadswim/tools/named_flags.hpp"

namespace beadswim {
namespace {

CLI::Validator relaxation_time() {
  const auto fault = [](const std::string& text) {
    std::string why = finite_positive()(text);
    if (!why.empty() || std::stod(text) > 0.5) return why;
    return "the relaxation time " + text +
           " is not above 0.5, so the viscosity (tau - 1/2)/3 would not be positive; values from 0.6 to 1.5 "
           "work well";
  };
  return CLI::Validator(fault, "");
}

void add_model(CLI::App& program, RunOptions& options) {
  begin_group(program, "Model");
  add_choice(
      program, "--model", options.settings.model,
      "lbm (lattice), mobilities rpy, rpy+near, multipole, oseen, unsteady, or auto (the cheapest run)")
      ->default_str("lbm; auto with --plan or --tolerance");
  program.add_flag(
      "--plan", options.plan,
      "Run nothing; print the expected error and cost of all possible runs, and the cheapest run within "
      "--tolerance. If you give --tolerance and no run is within it, the exit status is 2.");
  program
      .add_option("--tolerance", options.tolerance,
                  "Largest relative error of velocity and arm amplitudes for --plan and --model auto; with "
                  "another model a former name of --sum-tolerance [1]")
      ->type_name("E")
      ->check(finite_positive())
      ->default_str("0.03");
}

void add_length(CLI::App& program, RunSettings& settings) {
  begin_group(program, "Length and sampling");
  program
      .add_option("--cycles", settings.cycles,
                  "Length of the run, also fractional; the base period is the driving period that all "
                  "swimmers share, otherwise the period of the first swimmer's type [base period]")
      ->type_name("C")
      ->check(finite_positive());
  program
      .add_option("--frames-per-cycle", settings.frames_per_cycle,
                  "Number of evenly spaced frames of the trajectory per base period; also the number of "
                  "samples per driving period to which strokes are fitted")
      ->type_name("N")
      ->check(whole_number(4, 1000000));
}

void add_mobility(CLI::App& program, MobilitySettings& mobility) {
  begin_group(program, "Model");
  program
      .add_option("--sum-tolerance", mobility.tolerance,
                  "Largest relative error (root mean square) of the bead velocities that a mobility model "
                  "sums up in a step [1]")
      ->type_name("E")
      ->check(product_tolerance());
  program
      .add_option("--multipole-order", mobility.multipole_order,
                  "Highest moment of the force on each bead, for the models multipole and unsteady: 0 (force "
                  "alone, as rpy), 1 (with stresslets), 2 (with second moments)")
      ->type_name("N")
      ->check(whole_number(0, 2));
  add_switch(program, "--reynolds-stress", mobility.reynolds_stress,
             "Add the Reynolds stress of the flow, for --model unsteady");
  begin_group(program, "Length and sampling");
  program
      .add_option("--steps-per-cycle", mobility.steps_per_cycle,
                  "Number of time steps per shortest driving period, for mobility models; frames between "
                  "steps are extrapolated")
      ->type_name("N")
      ->check(whole_number(20, 1000000))
      ->default_str("100, raised to a multiple of the frames");
}

void add_resolution(CLI::App& program, LatticeSettings& lattice) {
  begin_group(program, "Lattice (model lbm)");
  program
      .add_option("--cells-per-radius", lattice.cells_per_radius,
                  "Resolution of the lattice: smallest bead radius in cells [cell]")
      ->type_name("N")
      ->check(finite_positive())
      ->default_str("the layout's, else 4");
  program
      .add_option("--relaxation-time", lattice.relaxation_time,
                  "Relaxation time tau, adjusted to whole steps per period; the time step follows from the "
                  "viscosity nu = (tau - 1/2)/3 cell^2/step [step]")
      ->type_name("TAU")
      ->check(relaxation_time())
      ->default_str("the layout's, else 1");
}

std::string refinement_text(const std::optional<int>& levels) {
  if (!levels) return "auto";
  return *levels == 0 ? "off" : fmt::format("{}", *levels);
}

/// Adds the flag --refine, whose value is off, auto or a number of levels.
void add_refinement(CLI::App& program, LatticeSettings& lattice) {
  const auto fault = [](const std::string& text) -> std::string {
    if (text == "off" || text == "auto" || whole_number(1, max_finer_levels)(text).empty()) return {};
    return fmt::format("use off, auto, or the number of finer levels, from 1 to {}", max_finer_levels);
  };
  program
      .add_option_function<std::string>(
          "--refine",
          [&lattice](const std::string& text) {
            lattice.refinement = text == "off" ? 0 : std::stoi(text == "auto" ? "0" : text);
            if (text == "auto") lattice.refinement.reset();
          },
          "Number of levels of cells below the coarsest, each with cells of half the size, around the beads; "
          "auto: the cheapest number; off: cells of one size")
      ->run_callback_for_default()  // --restart sets values from the checkpoint with default_val()
      ->type_name("off|auto|N")
      ->check(CLI::Validator(fault, ""))
      ->default_str("off");
}

void add_beads_in_fluid(CLI::App& program, LatticeSettings& lattice) {
  add_choice(program, "--bead-boundary", lattice.bead_boundary,
             "No-slip condition on beads: staircase (half-way bounce-back), cli (linear interpolation), mr "
             "(multireflection), psm (partially saturated cells)");
  add_switch(program, "--delay-correction", lattice.delay_correction,
             "Increase the bead density to compensate the delay with which the lattice fluid exerts its "
             "force on a bead");
  add_switch(program, "--radius-correction", lattice.radius_correction,
             "Adjust the bead radius on the lattice so that the drag, averaged over positions within a cell, "
             "is that of a sphere with the layout's radius");
  add_switch(
      program, "--lubrication", lattice.lubrication,
      "Add the part of the lubrication force between close surfaces that the lattice does not resolve");
  program
      .add_option("--friction", lattice.friction,
                  "Coefficient of Coulomb friction between beads in contact [1]")
      ->type_name("MU")
      ->check(finite_non_negative());
  add_choice(program, "--precision", lattice.precision,
             "Floating-point precision of the fluid populations; single needs half the memory and a little "
             "over half the time");
}

void add_stops(CLI::App& program, RunOptions& options) {
  begin_group(program, "Checkpoints and restart");
  program
      .add_option("--checkpoint-every", options.settings.checkpoint_every,
                  "Interval between checkpoints, which are written alternately to FILE.h5md.ckpt.0 and "
                  "FILE.h5md.ckpt.1 [base period]")
      ->type_name("C")
      ->check(finite_positive())
      ->default_str("only at a stop by time or signal");
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
  program
      .add_option("--flow-every", options.settings.flow_every,
                  "Interval between flow fields (velocity, pressure, beads) for ParaView, which "
                  "FILE.h5md.flow.pvd lists [base period]")
      ->type_name("C")
      ->check(finite_positive())
      ->default_str("none");
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
  add_length(program, options.settings);
  add_mobility(program, options.settings.mobility);
  add_resolution(program, options.settings.lattice);
  add_refinement(program, options.settings.lattice);
  add_beads_in_fluid(program, options.settings.lattice);
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

/// Without a plan, uses --tolerance of a mobility model as --sum-tolerance, its name in later versions.
/// Throws InputError if the model is lbm, if both flags are given, if the value is invalid for
/// --sum-tolerance, or at a restart.
void apply_former_tolerance(RunOptions& options) {
  if (!options.tolerance || options.plan || options.settings.model == RunModel::automatic) return;
  if (!options.restart.empty()) throw InputError("--tolerance", restart_keeps_model);
  if (options.settings.model == RunModel::lbm || options.given.contains("--sum-tolerance"))
    throw InputError("--tolerance", "the flag applies to --plan and --model auto only; leave it out");
  if (const std::string why = product_tolerance()(fmt::format("{}", *options.tolerance)); !why.empty())
    throw InputError("--tolerance", why);
  options.settings.mobility.tolerance = *options.tolerance;
  options.given.insert("--sum-tolerance");
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
                                                const FlagValues& defaults) {
  const auto program = make_program(
      "beadswim-run",
      "Simulates the swimmers of a layout in a lattice-Boltzmann fluid, or with a mobility (fluid without "
      "inertia). Writes the trajectory of the beads (H5MD) and prints the run record (JSON) with velocity "
      "and stroke of each cycle. Use mpirun -n N to run on N ranks.");
  RunOptions options;
  add_flags(*program, options);
  for (const auto& [flag, value] : defaults) {
    CLI::Option* option = program->get_option_no_throw(flag);
    if (option == nullptr || option->get_items_expected_max() == 0)
      throw InputError("--restart",
                       fmt::format("this program does not know the flag {} of the checkpoint's run; continue "
                                   "with the program version that wrote the checkpoint",
                                   flag));
    try {
      option->default_val(value);
    } catch (const CLI::Error& error) {
      throw InputError(
          "--restart",
          fmt::format("this program does not know the value of a flag of the checkpoint's run: {}",
                      error.what()));
    }
  }
  if (const auto status = parse_command_line(*program, argc, argv)) return *status;
  for (const CLI::Option* option : program->get_options()) {
    if (option->count() > 0) options.given.insert(option->get_name());
  }
  if (options.output.empty() && options.restart.empty() && !options.plan)
    throw InputError("--output", "the flag is missing; name the trajectory to write with -o FILE.h5md");
  require_short_name(options.output);
  const bool is_model_given = options.given.contains("--model") || defaults.contains("--model");
  if (!is_model_given && (options.plan || options.tolerance)) options.settings.model = RunModel::automatic;
  if (options.settings.model == RunModel::automatic && is_model_given && !options.restart.empty())
    throw InputError("--model", restart_keeps_model);
  apply_former_tolerance(options);
  options.provenance = provenance_record(*program);
  return options;
}

void refuse_flags(const RunOptions& options, std::initializer_list<const char*> flags,
                  const std::string& why) {
  for (const char* flag : flags)
    if (options.given.contains(flag)) throw InputError(flag, why);
}

void refuse_flags_of_other_models(const RunOptions& options, RunModel model) {
  if (model == RunModel::lbm) {
    refuse_flags(options, {"--sum-tolerance", "--steps-per-cycle", "--multipole-order", "--reynolds-stress"},
                 "the flag applies to mobility models only; leave it out, or add --model rpy, rpy+near, "
                 "multipole, oseen or unsteady");
    return;
  }
  refuse_flags(
      options,
      {"--cells-per-radius", "--relaxation-time", "--bead-boundary", "--delay-correction",
       "--radius-correction", "--lubrication", "--friction", "--precision", "--refine", "--flow-every"},
      "the flag applies to the lattice only; leave the flag out, or use --model lbm instead of " +
          to_text(model));
  if (!has_moment_order(*mobility_model(model)))
    refuse_flags(options, {"--multipole-order"},
                 "the flag applies to the models multipole and unsteady only; leave it out, or add --model "
                 "multipole");
  if (model != RunModel::unsteady)
    refuse_flags(options, {"--reynolds-stress"},
                 "the flag applies to the model unsteady only; leave it out, or add --model unsteady");
}

FlagValues result_flags(const RunSettings& settings) {
  if (settings.model != RunModel::lbm) {
    FlagValues values{{"--model", to_text(settings.model)},
                      {"--frames-per-cycle", fmt::format("{}", settings.frames_per_cycle)},
                      {"--sum-tolerance", fmt::format("{}", settings.mobility.tolerance)}};
    if (has_moment_order(*mobility_model(settings.model)))
      values["--multipole-order"] = fmt::format("{}", settings.mobility.multipole_order);
    if (settings.model == RunModel::unsteady)
      values["--reynolds-stress"] = on_or_off(settings.mobility.reynolds_stress);
    if (settings.mobility.steps_per_cycle)
      values["--steps-per-cycle"] = fmt::format("{}", *settings.mobility.steps_per_cycle);
    return values;
  }
  FlagValues values{{"--model", to_text(settings.model)},
                    {"--frames-per-cycle", fmt::format("{}", settings.frames_per_cycle)},
                    {"--bead-boundary", to_text(settings.lattice.bead_boundary)},
                    {"--delay-correction", on_or_off(settings.lattice.delay_correction)},
                    {"--radius-correction", on_or_off(settings.lattice.radius_correction)},
                    {"--lubrication", on_or_off(settings.lattice.lubrication)},
                    {"--friction", fmt::format("{}", settings.lattice.friction)},
                    {"--precision", to_text(settings.lattice.precision)},
                    {"--refine", refinement_text(settings.lattice.refinement)}};
  if (settings.lattice.cells_per_radius)
    values["--cells-per-radius"] = fmt::format("{}", *settings.lattice.cells_per_radius);
  if (settings.lattice.relaxation_time)
    values["--relaxation-time"] = fmt::format("{}", *settings.lattice.relaxation_time);
  return values;
}

FlagValues length_and_output_flags(const RunSettings& settings) {
  FlagValues values{{"--cycles", fmt::format("{}", settings.cycles)}};
  if (settings.checkpoint_every) values["--checkpoint-every"] = fmt::format("{}", *settings.checkpoint_every);
  if (settings.flow_every) values["--flow-every"] = fmt::format("{}", *settings.flow_every);
  return values;
}

}  // namespace beadswim
