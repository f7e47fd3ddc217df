#include "command_line/options.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <map>

#include "beadswim/mobility/mobility_model.hpp"
#include "beadswim/scene/names.hpp"
#include "beadswim/tools/program.hpp"

namespace beadswim {
namespace {

const std::map<std::string, ProgressStyle> progress_styles{{"auto", ProgressStyle::automatic},
                                                           {"bar", ProgressStyle::bar},
                                                           {"lines", ProgressStyle::lines},
                                                           {"json", ProgressStyle::json},
                                                           {"none", ProgressStyle::none}};

const std::map<std::string, Precision> precisions{{name_of(Precision::fp64), Precision::fp64},
                                                  {name_of(Precision::fp32), Precision::fp32}};

template <typename Value>
std::vector<std::string> names_of(const std::map<std::string, Value>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  return names;
}

std::vector<std::string> model_names() {
  std::vector<std::string> names = all_names(mobility_model_names);
  names.insert(names.begin(), "lbm");
  names.push_back("auto");
  return names;
}

CLI::Validator relaxation_time() {
  const auto fault = [](const std::string& text) {
    std::string why = finite_positive()(text);
    if (!why.empty() || std::stod(text) > 0.5) return why;
    return text + " is not above 0.5, where the viscosity (tau - 1/2)/3 vanishes; 0.6 to 1.5 work well";
  };
  return CLI::Validator(fault, "");
}

/// Flags whose values are words.
struct Words {
  std::string model, bead_boundary, delay_correction, radius_correction, lubrication, precision, progress;
};

/// A flag that takes one of some words.
void add_word(CLI::App& program, const std::string& flag, std::string& word,
              const std::vector<std::string>& words, const std::string& initial, const std::string& help) {
  program.add_option(flag, word, help)
      ->check(one_of(words))
      ->type_name(fmt::format("{}", fmt::join(words, "|")))
      ->default_val(initial);
}

std::string on_or_off(bool choice) {
  return choice ? "on" : "off";
}

void add_flags(CLI::App& program, RunOptions& options, Words& words) {
  program.add_option("LAYOUT", options.layout, "Layout, as beadswim-layout writes it; - for standard input.");
  program
      .add_option(
          "-o,--output", options.output,
          "Trajectory to write (H5MD); an older file of that name is replaced when the run ends. Needed, but "
          "with --restart the checkpoint's.")
      ->type_name("FILE.h5md")
      ->default_str("");
  add_word(
      program, "--model", words.model, model_names(), "auto",
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
  program
      .add_option("--cycles", options.settings.cycles,
                  "Length of the run, in periods of the first swimmer's type; fractions allowed.")
      ->check(finite_positive());
  program
      .add_option("--frames-per-cycle", options.settings.frames_per_cycle,
                  "Frames of the trajectory in a cycle of the base period, at most one a step; strokes are "
                  "fitted to as many samples "
                  "of each swimmer's own period.")
      ->check(whole_number(4, 1000000));
  program
      .add_option(
          "--tolerance", options.settings.mobility.tolerance,
          "auto, and --plan: largest error of velocity and arms' amplitudes that the run may have, relative. "
          "rpy, rpy+near, oseen: error of bead velocities by the sum over pairs and images, relative to "
          "their "
          "root mean square.")
      ->check(finite_positive());
  program
      .add_option("--steps-per-cycle", options.settings.mobility.steps_per_cycle,
                  "rpy, rpy+near, oseen: time steps in the shortest period of any swimmer's driving.")
      ->check(whole_number(20, 1000000));
  program
      .add_option("--cells-per-radius", options.settings.lattice.cells_per_radius,
                  "Cells per smallest bead radius [default: the layout's, else 4]")
      ->check(finite_positive())
      ->default_str("");
  program
      .add_option(
          "--relaxation-time", options.settings.lattice.relaxation_time,
          "tau, in time steps; sets the step: nu_lattice = (tau - 1/2)/3. Adjusted so that a period is a "
          "whole number of steps [default: the layout's, else 1]")
      ->check(relaxation_time())
      ->default_str("");
  add_word(
      program, "--bead-boundary", words.bead_boundary, bead_scheme_names(),
      name_of(options.settings.lattice.bead_boundary),
      "How the fluid meets a bead: staircase, covered cells that bounce back half-way (the "
      "paper's); cli, its surface where it is along each link, by central linear interpolation; mr, the "
      "same by multireflection, exact for parabolic flow; psm, no surface but a force in each cell by the "
      "exact part of it that the bead fills.");
  add_word(program, "--delay-correction", words.delay_correction, {"on", "off"},
           on_or_off(options.settings.lattice.delay_correction),
           "on: beads are heavier on the lattice by what makes up for the time by which the fluid's force "
           "comes late there, 3/2 (tau - 1/2) + 1 steps; the record says the density.");
  add_word(program, "--radius-correction", words.radius_correction, {"on", "off"},
           on_or_off(options.settings.lattice.radius_correction),
           "on: beads have on the lattice the radius for which their drag, as a mean over places within a "
           "cell, is "
           "that of the layout's radius; the record says which.");
  add_word(program, "--lubrication", words.lubrication, {"on", "off"},
           on_or_off(options.settings.lattice.lubrication),
           "on: beads closer than the lattice resolves feel the rest of the film's resistance; the record "
           "says below which gaps. Beads that touch repel each other either way.");
  program
      .add_option("--friction", options.settings.lattice.friction,
                  "Coulomb's coefficient of friction between beads that touch, no unit.")
      ->check(finite_non_negative());
  add_word(program, "--precision", words.precision, names_of(precisions), name_of(Precision::fp64),
           "Of the populations. single takes half the memory and somewhat over half the time; the run "
           "says when it would change the result.");
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
  program
      .add_option(
          "--flow-every", options.settings.flow_every,
          "Write velocity, pressure and bead of every cell to FILE.flow.pvd, each so many cycles [default: "
          "none]")
      ->check(finite_positive())
      ->default_str("");
  add_word(program, "--progress", words.progress, names_of(progress_styles), "auto",
           "Progress on standard error: bar; json or lines, one each 10 s; none; auto is bar on a terminal, "
           "else lines.");
  program.add_flag("!--no-provenance", options.with_provenance,
                   "Leave cost and provenance out of the run record, so that equal runs give equal bytes.");
}

/// What it is of, and how large it may be, depends on the model.
void require_fitting_tolerance(const RunOptions& options) {
  if (!options.given.contains("--tolerance") || options.plan || options.settings.model == "lbm" ||
      options.settings.model == "auto")
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
      "bead trajectories (H5MD) and prints "
      "the run "
      "record, with velocity and stroke of each cycle, as JSON. Run it under mpirun -n N for N ranks.");
  RunOptions options;
  Words words;
  add_flags(*program, options, words);
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
  options.settings.model = words.model == "auto" && !is_to_be_planned ? "lbm" : words.model;
  require_fitting_tolerance(options);
  options.settings.lattice.bead_boundary = bead_scheme_named(words.bead_boundary);
  options.settings.lattice.delay_correction = words.delay_correction == "on";
  options.settings.lattice.radius_correction = words.radius_correction == "on";
  options.settings.lattice.lubrication = words.lubrication == "on";
  options.settings.lattice.precision = precisions.at(words.precision);
  options.progress = progress_styles.at(words.progress);
  options.provenance = provenance_record(*program);
  return options;
}

void refuse_flags(const RunOptions& options, std::initializer_list<const char*> flags,
                  const std::string& why) {
  for (const char* flag : flags)
    if (options.given.contains(flag)) throw InputError(flag, why);
}

void refuse_lattice_flags(const RunOptions& options, const std::string& model) {
  refuse_flags(options,
               {"--cells-per-radius", "--relaxation-time", "--bead-boundary", "--delay-correction",
                "--radius-correction", "--lubrication", "--friction", "--precision", "--flow-every"},
               "is of the lattice; leave it out, or run with --model lbm instead of " + model);
}

FlagValues course_of(const RunSettings& settings) {
  if (settings.model != "lbm") {
    return {{"--model", settings.model},
            {"--frames-per-cycle", fmt::format("{}", settings.frames_per_cycle)},
            {"--tolerance", fmt::format("{}", settings.mobility.tolerance)},
            {"--steps-per-cycle", fmt::format("{}", settings.mobility.steps_per_cycle)}};
  }
  FlagValues values{{"--model", settings.model},
                    {"--frames-per-cycle", fmt::format("{}", settings.frames_per_cycle)},
                    {"--bead-boundary", name_of(settings.lattice.bead_boundary)},
                    {"--delay-correction", on_or_off(settings.lattice.delay_correction)},
                    {"--radius-correction", on_or_off(settings.lattice.radius_correction)},
                    {"--lubrication", on_or_off(settings.lattice.lubrication)},
                    {"--friction", fmt::format("{}", settings.lattice.friction)},
                    {"--precision", name_of(settings.lattice.precision)}};
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
