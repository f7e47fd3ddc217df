#include "command_line/options.hpp"

#include <fmt/core.h>

#include "beadswim/tools/named_flags.hpp"

namespace beadswim {
namespace {

CLI::Validator relaxation_time() {
  const auto fault = [](const std::string& text) {
    std::string why = finite_positive()(text);
    if (!why.empty() || std::stod(text) > 0.5) return why;
    return text + " is not above 0.5, where the viscosity (tau - 1/2)/3 vanishes; 0.6 to 1.5 work well";
  };
  return CLI::Validator(fault, "");
}

void add_model(CLI::App& program, RunOptions& options) {
  add_choice(
      program, "--model", options.settings.model,
      "lbm: beads resolved in a lattice-Boltzmann fluid. rpy: beads as points without inertia, by Rotne and "
      "Prager's mobility of all pairs and images; rpy+near: likewise, and exact along the line of a "
      "swimmer's beads and of two that are near each other; oseen: by Oseen's. auto: with --tolerance the "
      "model and resolution that --plan finds cheapest within it; without, lbm.");
  program.add_flag(
      "--plan", options.plan,
      "Run nothing; say of every model and resolution that the flags leave open what error and "
      "cost to expect, which is the cheapest within --tolerance (3 % if left out), and which "
      "smaller scene would do: a table on standard error, JSON on standard output. Exit status 2 "
      "if none is within it.");
}

void add_length(CLI::App& program, RunSettings& settings) {
  program
      .add_option("--cycles", settings.cycles,
                  "Length of the run, in periods of the first swimmer's type; fractions allowed.")
      ->check(finite_positive());
  program
      .add_option("--frames-per-cycle", settings.frames_per_cycle,
                  "Frames of the trajectory in a cycle of the base period, at most one a step; strokes are "
                  "fitted to as many samples "
                  "of each swimmer's own period.")
      ->check(whole_number(4, 1000000));
}

void add_mobility(CLI::App& program, MobilitySettings& mobility) {
  program
      .add_option(
          "--tolerance", mobility.tolerance,
          "auto, and --plan: largest error of velocity and arms' amplitudes that the run may have, relative. "
          "rpy, rpy+near, oseen: error of bead velocities by the sum over pairs and images, relative to "
          "their root mean square.")
      ->check(finite_positive());
  program
      .add_option("--steps-per-cycle", mobility.steps_per_cycle,
                  "rpy, rpy+near, oseen: time steps in the shortest period of any swimmer's driving.")
      ->check(whole_number(20, 1000000));
}

void add_resolution(CLI::App& program, LatticeSettings& lattice) {
  program
      .add_option("--cells-per-radius", lattice.cells_per_radius,
                  "Cells per smallest bead radius [default: the layout's, else 4]")
      ->check(finite_positive())
      ->default_str("");
  program
      .add_option(
          "--relaxation-time", lattice.relaxation_time,
          "tau, in time steps; sets the step: nu_lattice = (tau - 1/2)/3. Adjusted so that a period is a "
          "whole number of steps [default: the layout's, else 1]")
      ->check(relaxation_time())
      ->default_str("");
}

void add_beads_in_fluid(CLI::App& program, LatticeSettings& lattice) {
  add_choice(
      program, "--bead-boundary", lattice.bead_boundary,
      "How the fluid meets a bead: staircase, covered cells that bounce back half-way (the "
      "paper's); cli, its surface where it is along each link, by central linear interpolation; mr, the "
      "same by multireflection, exact for parabolic flow; psm, no surface but a force in each cell by the "
      "exact part of it that the bead fills.");
  add_switch(program, "--delay-correction", lattice.delay_correction,
             "on: beads are heavier on the lattice by what makes up for the time by which the fluid's force "
             "comes late there, 3/2 (tau - 1/2) + 1 steps; the record says the density.");
  add_switch(program, "--radius-correction", lattice.radius_correction,
             "on: beads have on the lattice the radius for which their drag, as a mean over places within a "
             "cell, is that of the layout's radius; the record says which.");
  add_switch(program, "--lubrication", lattice.lubrication,
             "on: beads closer than the lattice resolves feel the rest of the film's resistance; the record "
             "says below which gaps. Beads that touch repel each other either way.");
  program
      .add_option("--friction", lattice.friction,
                  "Coulomb's coefficient of friction between beads that touch, no unit.")
      ->check(finite_non_negative());
  add_choice(program, "--precision", lattice.precision,
             "Of the populations. single takes half the memory and somewhat over half the time; the run "
             "says when it would change the result.");
}

void add_stops(CLI::App& program, RunOptions& options) {
  program
      .add_option(
          "--checkpoint-every", options.settings.checkpoint_every,
          "Keep the run's state in FILE.h5md.ckpt.0 and .1 in turn, each so many cycles and at the end; "
          "fractions allowed [default: only when the run is stopped by time or signal]")
      ->check(finite_positive())
      ->default_str("");
  program
      .add_option(
          "--restart", options.restart,
          "Go on from this checkpoint, or from the last whole one of this trajectory, on any number of "
          "ranks, to the same bits as an unbroken run. Layout and flags are the checkpoint's; --cycles "
          "(of the whole run) and outputs may be given anew. The trajectory goes on from the checkpoint.")
      ->type_name("FILE.h5md|FILE.h5md.ckpt.N")
      ->default_str("");
  program
      .add_option(
          "--time-limit", options.time_limit,
          "Stop after this many seconds with results and a checkpoint, and exit status 4, as SIGINT, SIGTERM "
          "and SIGUSR1 do [default: none]")
      ->check(finite_positive())
      ->default_str("");
}

void add_outputs(CLI::App& program, RunOptions& options) {
  program
      .add_option(
          "--flow-every", options.settings.flow_every,
          "Write velocity, pressure and bead of every cell to FILE.flow.pvd, each so many cycles [default: "
          "none]")
      ->check(finite_positive())
      ->default_str("");
  add_choice(
      program, "--progress", options.progress,
      "Progress on standard error: bar; json or lines, one each 10 s; none; auto is bar on a terminal, "
      "else lines.");
  program.add_flag("!--no-provenance", options.with_provenance,
                   "Leave cost and provenance out of the run record, so that equal runs give equal bytes.");
}

/// Adds the flags in the order of the help.
void add_flags(CLI::App& program, RunOptions& options) {
  program.add_option("LAYOUT", options.layout, "Layout, as beadswim-layout writes it; - for standard input.");
  program
      .add_option(
          "-o,--output", options.output,
          "Trajectory to write (H5MD); an older file of that name is replaced when the run ends. Needed, but "
          "with --restart the checkpoint's.")
      ->type_name("FILE.h5md")
      ->default_str("");
  add_model(program, options);
  add_length(program, options.settings);
  add_mobility(program, options.settings.mobility);
  add_resolution(program, options.settings.lattice);
  add_beads_in_fluid(program, options.settings.lattice);
  add_stops(program, options);
  add_outputs(program, options);
}

/// What it is of, and how large it may be, depends on the model.
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
      "Runs a layout: bead-spring swimmers resolved in a fluid, or as points of a mobility (--model). Writes "
      "bead trajectories (H5MD) and prints the run record, with velocity and stroke of each cycle, as JSON. "
      "Run it under mpirun -n N for N ranks.");
  RunOptions options;
  options.settings.model = RunModel::automatic;
  add_flags(*program, options);
  for (const auto& [flag, value] : defaults) {
    CLI::Option* option = program->get_option_no_throw(flag);
    if (option == nullptr || option->get_items_expected_max() == 0)
      throw InputError(
          "--restart",
          fmt::format("the checkpoint's run has the flag {}, which this program does not know", flag));
    try {
      option->default_val(value);
    } catch (const CLI::Error& error) {
      throw InputError(
          "--restart",
          fmt::format("the checkpoint's run has a value that this program does not know: {}", error.what()));
    }
  }
  if (const auto status = parse_command_line(*program, argc, argv)) return *status;
  for (const CLI::Option* option : program->get_options()) {
    if (option->count() > 0) options.given.insert(option->get_name());
  }
  if (options.output.empty() && options.restart.empty() && !options.plan)
    throw InputError("--output", "is missing; name the trajectory to write, -o FILE.h5md");
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
  refuse_flags(options,
               {"--cells-per-radius", "--relaxation-time", "--bead-boundary", "--delay-correction",
                "--radius-correction", "--lubrication", "--friction", "--precision", "--flow-every"},
               "is of the lattice; leave it out, or run with --model lbm instead of " + to_text(model));
}

FlagValues course_of(const RunSettings& settings) {
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

FlagValues length_and_outputs_of(const RunSettings& settings) {
  FlagValues values{{"--cycles", fmt::format("{}", settings.cycles)}};
  if (settings.checkpoint_every) values["--checkpoint-every"] = fmt::format("{}", *settings.checkpoint_every);
  if (settings.flow_every) values["--flow-every"] = fmt::format("{}", *settings.flow_every);
  return values;
}

}  // namespace beadswim
