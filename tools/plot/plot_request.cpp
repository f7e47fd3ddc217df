#include "plot_request.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"

namespace beadswim {
namespace {

using Names = std::vector<std::string>;

/// Throws, with the nearest name, if the name is not among those allowed.
void require_name(const std::string& flag, const std::string& name, const Names& allowed) {
  if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) return;
  throw InputError(flag, unknown_name(name, allowed));
}

template <typename Value, std::size_t Count>
Value value_named(const std::string& flag, const std::string& name,
                  const std::array<std::pair<const char*, Value>, Count>& table) {
  Names allowed;
  for (const auto& entry : table) allowed.push_back(entry.first);
  require_name(flag, name, allowed);
  return std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.first == name; })
      ->second;
}

/// A whole number from 0 on, as CLI11 checks it: empty, or what is wrong.
std::string fault_of_whole_number(const std::string& text) {
  const bool digits =
      !text.empty() && text.size() <= 9 && text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? "" : fmt::format("\"{}\": must be a whole number from 0 on", text);
}

CLI::Validator whole_numbers() {
  return CLI::Validator(
      [](const std::string& text) {
        for (const std::string& part : CLI::detail::split(text, ',')) {
          if (const std::string fault = fault_of_whole_number(part); !fault.empty()) return fault;
        }
        return std::string{};
      },
      "");
}

CLI::Validator last_or_whole_number() {
  return CLI::Validator(
      [](const std::string& text) {
        return text == "last" || fault_of_whole_number(text).empty()
                   ? std::string{}
                   : fmt::format("\"{}\": must be last or a whole number from 0 on", text);
      },
      "");
}

void add_figure_flags(CLI::App& program, PlotRequest& request) {
  program
      .add_option("--relative-to", request.relative_to,
                  "Draw the difference of all velocities from this method's prediction at the same period or "
                  "separation, in percent.")
      ->type_name("METHOD")
      ->default_str("none");
  program
      .add_option(
          "--reference", request.reference,
          "From which errors of runs are measured, for speed-against-error: a prediction, by its best "
          "usable method or --method, or a run record of the same scene. Verdicts have theirs.")
      ->type_name("FILE")
      ->default_str("none");
  program
      .add_option("--against", request.against,
                  "What the stroke is drawn against: cycle (of runs; predictions are level lines), "
                  "amplitude-ratio (A/B of the driving) or phase (alpha of the driving).")
      ->type_name("cycle|amplitude-ratio|phase");
  program
      .add_option("--axes", request.axes,
                  "Axes of velocities: linear, log-y, log-log, or auto: logarithmic where the velocities are "
                  "positive and span over two decades (log-log for separation), else linear.")
      ->type_name("auto|linear|log-y|log-log");
  program
      .add_option(
          "--cycle", request.cycle,
          "Cycle of each run, unless drawn against the cycle: last, N (the Nth from the run's start) or "
          "mean:N (mean of the last N).")
      ->type_name("last|N|mean:N");
}

void add_trajectory_flags(CLI::App& program, PlotRequest& request) {
  program
      .add_option("--swimmers", request.swimmers,
                  "Swimmers whose trajectories are drawn, by id, separated by commas; all unless given. For "
                  "swimmer one, the layout's first unless given.")
      ->type_name("ID,...")
      ->check(whole_numbers())
      ->default_str("all");
  program
      .add_option("--beads", request.beads,
                  "Beads of a swimmer whose trajectories are drawn: 1, 2 and 3 from "
                  "its end to its head.")
      ->type_name("1|2|3,...");
  program.add_option("--along", request.along, "Coordinate of trajectories, not wrapped into the box.")
      ->type_name("x|y|z");
}

void add_swarm_flags(CLI::App& program, PlotRequest& request) {
  program
      .add_option("--frame", request.frame,
                  "Frame of the swarm's picture: last, or its number in the trajectory from 0, the start.")
      ->type_name("last|N")
      ->check(last_or_whole_number());
  program
      .add_option(
          "--colours", request.colours,
          "What the colours of a swarm go by: blocks of --block-swimmers, in a checkerboard; swimmers; "
          "or the layout's types.")
      ->type_name("blocks|swimmers|types");
  program
      .add_option("--block-swimmers", request.block_swimmers,
                  "Swimmers of a block along each axis, by the layers in which they stand in the layout; or "
                  "one number, the swimmers of a block in order of their ids.")
      ->type_name("NX,NY,NZ|N")
      ->check(number_list({1, 3}, whole_positive()));
  program
      .add_option("--repeat", request.repeat,
                  "Periodic copies of the box to draw along each axis, as of a reduced cell.")
      ->type_name("NX,NY,NZ")
      ->check(number_list({3}, whole_positive()));
  program
      .add_option("--mark", request.marks,
                  "Names of swimmers, written at their middle beads in a swarm's picture, by id.")
      ->type_name("NAME=ID,...")
      ->delimiter(',')
      ->default_str("none");
  program.add_flag(
      "--distances", request.distances,
      "In a swarm's picture, of a layout: distances C from a swimmer to the next of its block, D to "
      "that of the next block, along each axis.");
}

/// "A=3".
SwimmerMark parse_mark(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  const std::string id = sign == std::string::npos ? "" : text.substr(sign + 1);
  if (sign == 0 || id.empty() || !fault_of_whole_number(id).empty()) {
    throw InputError("--mark", fmt::format("\"{}\": must be a name and a swimmer's id, such as A=3", text));
  }
  return {text.substr(0, sign), std::stoi(id)};
}

/// A flag that was given, and the kinds that have a use for it.
struct GivenFlag {
  const char* name;
  bool given;
  Names kinds;
};

/// By comparison with what stands there unless given.
std::vector<GivenFlag> given_flags(const PlotRequest& request) {
  const PlotRequest unset;
  const Names records{stroke_kind, period_kind, separation_kind, speed_kind};
  return {{"--relative-to", request.relative_to != unset.relative_to, {period_kind, separation_kind}},
          {"--axes", request.axes != unset.axes, {period_kind, separation_kind}},
          {"--reference", request.reference != unset.reference, {speed_kind}},
          {"--against", request.against != unset.against, {stroke_kind}},
          {"--method", request.methods != unset.methods, records},
          {"--cycle", request.cycle != unset.cycle, records},
          {"--swimmers", request.swimmers != unset.swimmers, {trajectories_kind, swimmer_kind}},
          {"--beads", request.beads != unset.beads, {trajectories_kind}},
          {"--along", request.along != unset.along, {trajectories_kind}},
          {"--frame", request.frame != unset.frame, {swarm_kind}},
          {"--colours", request.colours != unset.colours, {swarm_kind}},
          {"--block-swimmers", request.block_swimmers != unset.block_swimmers, {swarm_kind}},
          {"--repeat", request.repeat != unset.repeat, {swarm_kind}},
          {"--mark", request.marks != unset.marks, {swarm_kind}},
          {"--distances", request.distances, {swarm_kind}}};
}

}  // namespace

void add_flags(CLI::App& program, PlotRequest& request) {
  program
      .add_option(
          "KIND", request.kind,
          "stroke: arm amplitudes and phase shift. velocity-against-period: velocity along the swimmer's "
          "axis, against the mean flow along periodic axes. separation: the same velocity against l/λ, "
          "the beads' smallest separation over their radius. speed-against-error: errors of velocity and "
          "stroke against core-seconds a period, by setting and resolution, and the front of those that none "
          "beats in both. trajectories: a coordinate of beads against time. swarm: a picture of all beads at "
          "one frame, or as laid out. swimmer: a labelled sketch of one of a layout. mobility-products: time "
          "of a product of mobility and forces against the number of beads, "
          "by beadswim-bench --beads "
          "--json.")
      ->type_name(
          "stroke|velocity-against-period|separation|speed-against-error|trajectories|swarm|swimmer|mobility-"
          "products");
  program
      .add_option(
          "FILES", request.files,
          "Run records (drawn as points) and predictions (as lines): one document a file, or one a line. "
          "One may be - for standard input. For trajectories and swarm: what beadswim-run wrote, .h5md or, "
          "of a run that goes on or was killed, .h5md.part. For swarm also, and for swimmer, a layout; for "
          "speed-against-error run records, or verdicts of beadswim-compare.")
      ->type_name("FILE...")
      ->default_str("");
  program.add_option("-o,--output", request.output, "Figure to write: .svg, .png, or - for SVG on stdout.")
      ->type_name("FILE");
  program
      .add_option(
          "--method", request.methods,
          "Methods to draw of each prediction, separated by commas, in this order; all for all; the best "
          "usable one unless given.")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->default_str("the best");
  add_figure_flags(program, request);
  add_trajectory_flags(program, request);
  add_swarm_flags(program, request);
}

void require_consistent(const PlotRequest& request) {
  const Names kinds{stroke_kind,       period_kind, separation_kind, speed_kind,
                    trajectories_kind, swarm_kind,  swimmer_kind,    products_kind};
  if (request.kind.empty()) {
    throw InputError("KIND", fmt::format("none given; there are {}", fmt::join(kinds, ", ")));
  }
  require_name("KIND", request.kind, kinds);
  for (const GivenFlag& flag : given_flags(request)) {
    if (!flag.given || std::ranges::find(flag.kinds, request.kind) != flag.kinds.end()) continue;
    throw InputError(flag.name, fmt::format("has no meaning for {}; leave it out", request.kind));
  }
  if (request.kind == speed_kind && request.reference.empty() && request.cycle != PlotRequest{}.cycle) {
    throw InputError("--cycle",
                     "has no meaning for verdicts, which have theirs; leave it out, or draw runs, with "
                     "--reference");
  }
}

std::optional<Abscissa> parse_against(const std::string& name) {
  using Choice = std::pair<const char*, std::optional<Abscissa>>;
  return value_named(
      "--against", name,
      std::array{Choice{"cycle", std::nullopt}, Choice{"amplitude-ratio", Abscissa::amplitude_ratio},
                 Choice{"phase", Abscissa::phase}});
}

Axes parse_axes(const std::string& name) {
  using Choice = std::pair<const char*, Axes>;
  return value_named("--axes", name,
                     std::array{Choice{"auto", Axes::automatic}, Choice{"linear", Axes::linear},
                                Choice{"log-y", Axes::log_y}, Choice{"log-log", Axes::log_log}});
}

TrajectoryFigureOptions trajectory_options(const PlotRequest& request) {
  using Axis = std::pair<const char*, int>;
  TrajectoryFigureOptions options;
  options.axis = value_named("--along", request.along, std::array{Axis{"x", 0}, Axis{"y", 1}, Axis{"z", 2}});
  if (!request.swimmers.empty()) options.swimmers = parse_whole_numbers(request.swimmers);
  options.beads.clear();
  for (const std::string& bead : CLI::detail::split(request.beads, ',')) {
    options.beads.push_back(
        value_named("--beads", bead, std::array{Axis{"1", 1}, Axis{"2", 2}, Axis{"3", 3}}));
  }
  return options;
}

std::optional<int> sketched_swimmer(const PlotRequest& request) {
  if (request.swimmers.empty()) return std::nullopt;
  const std::vector<int> ids = parse_whole_numbers(request.swimmers);
  if (ids.size() == 1) return ids.front();
  throw InputError("--swimmers", fmt::format("{} given; a sketch is of one swimmer", ids.size()));
}

SwarmFigureOptions swarm_options(const PlotRequest& request) {
  using Choice = std::pair<const char*, SwarmColours>;
  SwarmFigureOptions options;
  if (request.frame != "last")
    options.frame = static_cast<std::size_t>(parse_whole_numbers(request.frame)[0]);
  options.colours = value_named(
      "--colours", request.colours,
      std::array{Choice{"blocks", SwarmColours::blocks}, Choice{"swimmers", SwarmColours::swimmers},
                 Choice{"types", SwarmColours::types}});
  options.block_swimmers = parse_whole_numbers(request.block_swimmers);
  const std::vector<int> repeat = parse_whole_numbers(request.repeat);
  options.repeat = {repeat[0], repeat[1], repeat[2]};
  for (const std::string& mark : request.marks) options.marks.push_back(parse_mark(mark));
  options.distances = request.distances;
  return options;
}

}  // namespace beadswim
