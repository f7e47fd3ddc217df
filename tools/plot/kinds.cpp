#include "kinds.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>

#include "flags.hpp"
#include "product_figure.hpp"
#include "speed_figure.hpp"
#include "stroke_figure.hpp"
#include "swimmer_figure.hpp"
#include "trajectory_figure.hpp"
#include "velocity_figure.hpp"
#include "verdict_figure.hpp"

namespace beadswim {
namespace {

Drawing add_stroke_flags(CLI::App& command) {
  struct Flags {
    std::vector<std::string> methods;
    std::string cycle = "last";
    std::optional<Abscissa> against;
  };
  const auto flags = std::make_shared<Flags>();
  add_methods(command, flags->methods);
  add_cycle(command, flags->cycle);
  add_word(
      command, "--against", {"cycle", "amplitude-ratio", "phase"}, "cycle",
      "What the stroke is drawn against: cycle (predictions are level lines), amplitude-ratio (A/B of the "
      "driving) or phase (alpha of the driving).",
      [flags](const std::string& word) {
        flags->against.reset();
        if (word != "cycle") flags->against = word == "phase" ? Abscissa::phase : Abscissa::amplitude_ratio;
      });
  return [flags](const PlotFiles& files) {
    const CycleChoice cycle = parse_cycle_choice(flags->cycle);
    const PlotInputs inputs = read_plot_inputs(files.inputs, {flags->methods});
    return figure_to_svg(flags->against ? stroke_against(inputs, *flags->against, cycle)
                                        : stroke_by_cycle(inputs));
  };
}

template <Abscissa abscissa>
Drawing add_velocity_flags(CLI::App& command) {
  struct Flags {
    MethodChoice methods;
    std::string cycle = "last";
    Axes axes = Axes::automatic;
  };
  const auto flags = std::make_shared<Flags>();
  add_methods(command, flags->methods.methods);
  add_cycle(command, flags->cycle);
  command
      .add_option("--relative-to", flags->methods.relative_to,
                  "Draw the difference of all velocities from this method's prediction at the same period or "
                  "separation, in percent.")
      ->type_name("METHOD")
      ->default_str("none");
  add_choice(
      command, "--axes", flags->axes,
      std::string("Axes of the figure. auto is logarithmic where the velocities are positive and span over "
                  "two decades (") +
          (abscissa == Abscissa::separation_ratio ? "log-log" : "log-y") + "), else linear.");
  return [flags](const PlotFiles& files) {
    const CycleChoice cycle = parse_cycle_choice(flags->cycle);
    const PlotInputs inputs = read_plot_inputs(files.inputs, flags->methods);
    return figure_to_svg(velocity_figure(inputs, {abscissa, cycle, flags->axes}));
  };
}

Drawing add_speed_flags(CLI::App& command) {
  struct Flags {
    std::vector<std::string> methods;
    std::string cycle = "last", reference;
  };
  const auto flags = std::make_shared<Flags>();
  add_methods(command, flags->methods);
  add_cycle(command, flags->cycle);
  command
      .add_option(
          "--reference", flags->reference,
          "The prediction or the run record of the same scene from which errors of runs are measured. Of a "
          "prediction, its best usable method or --method counts. Verdicts have a reference already.")
      ->type_name("FILE")
      ->default_str("none");
  return [flags](const PlotFiles& files) {
    const CycleChoice cycle = parse_cycle_choice(flags->cycle);
    if (!flags->reference.empty()) {
      require_other_file(flags->reference, files.output);
      return figure_to_svg(
          speed_figure(read_plot_inputs(files.inputs, {}), {flags->reference, flags->methods, cycle}));
    }
    if (flags->cycle != Flags().cycle) {
      throw InputError("--cycle",
                       "has no meaning for verdicts, which have theirs; leave it out, or draw runs, with "
                       "--reference");
    }
    return figure_to_svg(verdict_figure(files.inputs, flags->methods));
  };
}

Drawing add_trajectory_flags(CLI::App& command) {
  const auto options = std::make_shared<TrajectoryFigureOptions>();
  add_whole_numbers(command, "--swimmers", options->swimmers, "all",
                    "Swimmers whose trajectories are drawn, by id, separated by commas.");
  command
      .add_option_function<std::string>(
          "--beads", [options](const std::string& text) { options->beads = parse_whole_numbers(text); },
          "Beads of a swimmer whose trajectories are drawn: 1, 2 and 3 from its end to its head.")
      ->type_name("1|2|3,...")
      ->check(number_list({}, one_of({"1", "2", "3"})))
      ->default_str("2");
  add_word(command, "--along", {"x", "y", "z"}, "x", "Coordinate of trajectories, not wrapped into the box.",
           [options](const std::string& word) { options->axis = word[0] - 'x'; });
  return
      [options](const PlotFiles& files) { return figure_to_svg(trajectory_figure(files.inputs, *options)); };
}

Drawing add_swarm_flags(CLI::App& command) {
  const auto options = std::make_shared<SwarmFigureOptions>();
  add_frame(command, options->frame);
  add_choice(
      command, "--colours", options->colours,
      "What the colours of swimmers go by: blocks of --block-swimmers, in a checkerboard; swimmers; or the "
      "layout's types.");
  command
      .add_option_function<std::string>(
          "--block-swimmers",
          [options](const std::string& text) { options->block_swimmers = parse_whole_numbers(text); },
          "Swimmers of a block along each axis, by the layers in which they stand in the layout; or "
          "one number, the swimmers of a block in order of their ids.")
      ->type_name("NX,NY,NZ|N")
      ->check(number_list({1, 3}, whole_positive()))
      ->default_str("1,3,3");
  command
      .add_option_function<std::string>(
          "--repeat",
          [options](const std::string& text) {
            std::ranges::copy(parse_whole_numbers(text), options->repeat.begin());
          },
          "Periodic copies of the box to draw along each axis, as of a reduced cell.")
      ->type_name("NX,NY,NZ")
      ->check(number_list({3}, whole_positive()))
      ->default_str("1,1,1");
  add_marks(command, options->marks);
  command.add_flag(
      "--distances", options->distances,
      "Draw, of a layout, the distances C from a swimmer to the next of its block, and D to that of the next "
      "block, along each axis.");
  return [options](const PlotFiles& files) {
    return swarm_picture_to_svg(swarm_figure(files.inputs, *options));
  };
}

Drawing add_swimmer_flags(CLI::App& command) {
  const auto ids = std::make_shared<std::vector<int>>();
  add_whole_numbers(command, "--swimmers", *ids, "the layout's first", "The swimmer that is drawn, by id.")
      ->type_name("ID");
  return [ids](const PlotFiles& files) {
    if (ids->size() > 1)
      throw InputError("--swimmers", fmt::format("{} given; a sketch is of one swimmer", ids->size()));
    const auto id = ids->empty() ? std::nullopt : std::optional(ids->front());
    return swimmer_sketch_to_svg(swimmer_figure(files.inputs, id));
  };
}

Drawing add_product_flags(CLI::App&) {
  return [](const PlotFiles& files) { return figure_to_svg(product_figure(files.inputs)); };
}

constexpr const char* records_and_predictions =
    "Run records (drawn as points) and predictions (as lines): one document a file, or one a line. One may "
    "be - "
    "for standard input.";

constexpr std::array kinds{
    PlotKind{"stroke", "Arm amplitudes and phase shift, against the cycle or the driving.",
             records_and_predictions, add_stroke_flags},
    PlotKind{"velocity-against-period",
             "Velocity along the swimmer's axis, against the mean flow along periodic axes.",
             records_and_predictions, add_velocity_flags<Abscissa::period>},
    PlotKind{"separation",
             "Velocity along the swimmer's axis against l/λ, the beads' separation over their radius.",
             records_and_predictions, add_velocity_flags<Abscissa::separation_ratio>},
    PlotKind{
        "speed-against-error",
        "Errors of velocity and stroke against core-seconds, with the front that none beats.",
        "Run records, with --reference, or verdicts of beadswim-compare: one document a file, or one a line. "
        "One may be - for standard input.",
        add_speed_flags},
    PlotKind{
        "trajectories", "A coordinate of beads against time.",
        "Trajectories that beadswim-run wrote: .h5md or, of a run that goes on or was killed, .h5md.part.",
        add_trajectory_flags},
    PlotKind{
        "swarm", "A picture of all beads at one frame, or as laid out.",
        "A layout, - for standard input; or a trajectory that beadswim-run wrote: .h5md or, of a run that "
        "goes on or was killed, .h5md.part.",
        add_swarm_flags},
    PlotKind{"swimmer", "A labelled sketch of one swimmer of a layout.", "A layout, - for standard input.",
             add_swimmer_flags},
    PlotKind{"mobility-products", "Time of a product of mobility and forces against the number of beads.",
             "Measurements by beadswim-bench --beads --json. One may be - for standard input.",
             add_product_flags}};

}  // namespace

std::span<const PlotKind> plot_kinds() {
  return kinds;
}

}  // namespace beadswim
