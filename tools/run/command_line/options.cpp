#include "command_line/options.hpp"

#include <fmt/core.h>

#include "beadswim/tools/named_flags.hpp"

namespace beadswim {
namespace {

CLI::Validator relaxation_time() {
  const auto fault = [](const std::string& text) {
    std::string why = finite_positive()(text);
    if (!why.empty() || std::stod(text) > 0.5) return why;
    return text +
           " is not above 0.5, so the viscosity (tau - 1/2)/3 would not be positive; values from 0.6 to 1.5 "
           "work well";
  };
  return CLI::Validator(fault, "");
}

void add_model(CLI::App& program, RunOptions& options) {
  begin_group(program, "Model");
  add_choice(
      program, "--model", options.settings.model,
      "What moves the beads: lbm, a lattice-Boltzmann fluid; rpy or oseen, a mobility; rpy+near, with near "
      "field; auto, the cheapest by --plan, or lbm without --tolerance");
  program.add_flag("--plan", options.plan,
                   "Run nothing; print expected error and cost of all possible runs, and the cheapest within "
                   "--tolerance (default here: 0.03). Exit status 2 if there is none.");
}

void add_length(CLI::App& program, RunSettings& settings) {
  begin_group(program, "Length and sampling");
  program.add_option("--cycles", settings.cycles, "Length of the run, fractions allowed [base period]")
      ->type_name("C")
      ->check(finite_positive());
  program
      .add_option("--frames-per-cycle", settings.frames_per_cycle,
                  "Frames of the trajectory per base period; also samples per period to fit strokes")
      ->type_name("N")
      ->check(whole_number(4, 1000000));
}

void add_mobility(CLI::App& program, MobilitySettings& mobility) {
  begin_group(program, "Model");
  program
      .add_option("--tolerance", mobility.tolerance,
                  "Largest relative error: with auto or --plan, of velocity and arm amplitudes; with rpy, "
                  "rpy+near or oseen, of bead velocities (root mean square) [1]")
      ->type_name("E")
      ->check(finite_positive());
  begin_group(program, "Length and sampling");
  program
      .add_option("--steps-per-cycle", mobility.steps_per_cycle,
                  "Time steps per shortest driving period, for models rpy, rpy+near and oseen")
      ->type_name("N")
      ->check(whole_number(20, 1000000));
}

void add_resolution(CLI::App& program, LatticeSettings& lattice) {
  begin_group(program, "Lattice (model lbm)");
  program.add_option("--cells-per-radius", lattice.cells_per_radius, "Cells per smallest bead radius [cell]")
      ->type_name("N")
      ->check(finite_positive())
      ->default_str("the layout's, else 4");
  program
      .add_option("--relaxation-time", lattice.relaxation_time,
                  "Relaxation time tau, which sets the time step: nu = (tau - 1/2)/3; adjusted so that a "
                  "period is a whole number of steps [step]")
      ->type_name("TAU")
      ->check(relaxation_time())
      ->default_str("the layout's, else 1");
}

void add_beads_in_fluid(CLI::App& program, LatticeSettings& lattice) {
  add_choice(program, "--bead-boundary", lattice.bead_boundary,
             "No-slip scheme on beads: staircase (half-way bounce-back, as in the paper), cli (linear "
             "interpolation), mr (multireflection), psm (partially saturated cells)");
  add_switch(program, "--delay-correction", lattice.delay_correction,
             "Increase bead density to compensate the delay of the fluid force on the lattice");
  add_switch(program, "--radius-correction", lattice.radius_correction,
             "Adjust bead radius so that the mean drag is that of the layout's radius");
  add_switch(program, "--lubrication", lattice.lubrication,
             "Add the part of lubrication that the lattice does not resolve");
  program.add_option("--friction", lattice.friction, "Coulomb friction coefficient of touching beads [1]")
      ->type_name("MU")
      ->check(finite_non_negative());
  add_choice(program, "--precision", lattice.precision,
             "Precision of the populations; single halves the memory and nearly halves the time");
}

void add_stops(CLI::App& program, RunOptions& options) {
  begin_group(program, "Checkpoints and restart");
  program
      .add_option("--checkpoint-every", options.settings.checkpoint_every,
                  "Interval of checkpoints, written to FILE.h5md.ckpt.0 and .1 in turn [base period]")
      ->type_name("C")
      ->check(finite_positive())
      ->default_str("only at a stop by time or signal");
  program
      .add_option("--restart", options.restart,
                  "Continue from a checkpoint, or the last one of a trajectory, with its layout and flags; "
                  "new --cycles (in total), outputs and number of ranks are allowed")
      ->type_name("FILE.h5md|FILE.h5md.ckpt.N")
      ->default_str("");
  program
      .add_option("--time-limit", options.time_limit,
                  "Wall time after which to stop with results, a checkpoint and exit status 4, as on SIGINT, "
                  "SIGTERM and SIGUSR1 [s]")
      ->type_name("S")
      ->check(finite_positive())
      ->default_str("none");
}

void add_outputs(CLI::App& program, RunOptions& options) {
  begin_group(program, "Output");
  program
      .add_option("--flow-every", options.settings.flow_every,
                  "Interval of flow fields in FILE.flow.pvd: velocity, pressure, beads [base period]")
      ->type_name("C")
      ->check(finite_positive())
      ->default_str("none");
  add_choice(program, "--progress", options.progress,
             "Progress on standard error; auto is bar on a terminal, else lines, every 10 s");
  program.add_flag("!--no-provenance", options.with_provenance,
                   "Leave cost and provenance out of the run record: equal runs then give equal bytes.");
}

/// Adds all flags. Provenance lists the flags in the same order.
void add_flags(CLI::App& program, RunOptions& options) {
  program.add_option("LAYOUT", options.layout, "Layout; - is standard input.");
  begin_group(program, "Output");
  program
      .add_option("-o,--output", options.output,
                  "Trajectory to write (H5MD), replaced when the run ends; required without --restart")
      ->type_name("FILE.h5md")
      ->default_str("");
  add_model(program, options);
  add_length(program, options.settings);
  add_mobility(program, options.settings.mobility);
  add_resolution(program, options.settings.lattice);
  add_beads_in_fluid(program, options.settings.lattice);
  add_stops(program, options);
  add_outputs(program, options);
  set_footer(program,
             {"beadswim-run layout.json --model rpy -o run.h5md >run.json",
              "mpirun -n 2 beadswim-run layout.json --cells-per-radius 2 --cycles 1 -o lbm.h5md >lbm.json"},
             "choosing-a-model.md");
}

/// Throws InputError if the model is a mobility and --tolerance is not a valid tolerance of mobility
/// products. In plans, --tolerance limits other errors (velocity and arm amplitudes) and has a wider range.
void require_fitting_tolerance(const RunOptions& options) {
  if (!options.given.contains("--tolerance") || options.plan || options.settings.model == RunModel::lbm ||
      options.settings.model == RunModel::automatic)
    return;
  if (const std::string why = product_tolerance()(fmt::format("{}", options.settings.mobility.tolerance));
      !why.empty())
    throw InputError("--tolerance", why);
}

}  // namespace

std::variant<RunOptions, int> parse_run_options(int argc, const char* const* argv,
                                                const FlagValues& defaults) {
  const auto program = make_program(
      "beadswim-run",
      "Runs a layout: swimmers in a lattice-Boltzmann fluid, or by a mobility. Writes bead trajectories "
      "(H5MD) and prints the run record (JSON): velocity and stroke of each cycle. Use mpirun -n N for N "
      "ranks.");
  RunOptions options;
  options.settings.model = RunModel::automatic;
  add_flags(*program, options);
  for (const auto& [flag, value] : defaults) {
    CLI::Option* option = program->get_option_no_throw(flag);
    if (option == nullptr || option->get_items_expected_max() == 0)
      throw InputError("--restart",
                       fmt::format("this program does not know the flag {} of the checkpoint's run", flag));
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
  const bool is_to_be_planned = options.plan || options.given.contains("--tolerance");
  if (options.settings.model == RunModel::automatic && !is_to_be_planned)
    options.settings.model = RunModel::lbm;
  require_fitting_tolerance(options);
  options.provenance = provenance_record(*program);
  return options;
}

void refuse_flags(const RunOptions& options, std::initializer_list<const char*> flags,
                  const std::string& why) {
  for (const char* flag : flags)
    if (options.given.contains(flag)) throw InputError(flag, why);
}

void refuse_lattice_flags(const RunOptions& options, RunModel model) {
  refuse_flags(
      options,
      {"--cells-per-radius", "--relaxation-time", "--bead-boundary", "--delay-correction",
       "--radius-correction", "--lubrication", "--friction", "--precision", "--flow-every"},
      "the flag applies to the lattice only; leave it out, or use --model lbm instead of " + to_text(model));
}

FlagValues result_flags(const RunSettings& settings) {
  if (settings.model != RunModel::lbm) {
    return {{"--model", to_text(settings.model)},
            {"--frames-per-cycle", fmt::format("{}", settings.frames_per_cycle)},
            {"--tolerance", fmt::format("{}", settings.mobility.tolerance)},
            {"--steps-per-cycle", fmt::format("{}", settings.mobility.steps_per_cycle)}};
  }
  FlagValues values{{"--model", to_text(settings.model)},
                    {"--frames-per-cycle", fmt::format("{}", settings.frames_per_cycle)},
                    {"--bead-boundary", to_text(settings.lattice.bead_boundary)},
                    {"--delay-correction", on_or_off(settings.lattice.delay_correction)},
                    {"--radius-correction", on_or_off(settings.lattice.radius_correction)},
                    {"--lubrication", on_or_off(settings.lattice.lubrication)},
                    {"--friction", fmt::format("{}", settings.lattice.friction)},
                    {"--precision", to_text(settings.lattice.precision)}};
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
