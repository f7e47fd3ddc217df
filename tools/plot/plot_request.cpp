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
  throw InputError(flag, fmt::format("unknown \"{}\"; did you mean \"{}\"? There are {}", name,
                                     nearest_name(name, allowed), fmt::join(allowed, ", ")));
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

void add_figure_flags(CLI::App& program, PlotRequest& request) {
  program
      .add_option("--relative-to", request.relative_to,
                  "Draw the difference of all velocities from this method's prediction at the same period or "
                  "separation, in percent.")
      ->type_name("METHOD")
      ->default_str("none");
  program
      .add_option("--reference", request.reference,
                  "From which errors are measured, for speed-against-error: a prediction, by its best usable "
                  "method or --method, or a run record of the same scene.")
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

}  // namespace

void add_flags(CLI::App& program, PlotRequest& request) {
  program
      .add_option(
          "KIND", request.kind,
          "stroke: arm amplitudes and phase shift. velocity-against-period: velocity along the swimmer's "
          "axis, against the mean flow along periodic axes. separation: the same velocity against l/λ, "
          "the beads' smallest separation over their radius. speed-against-error: periods that a core does "
          "in "
          "an hour, against the error of velocity and stroke, by setting and resolution.")
      ->type_name("stroke|velocity-against-period|separation|speed-against-error");
  program
      .add_option(
          "FILES", request.files,
          "Run records (drawn as points) and predictions (as lines): one document a file, or one a line. "
          "One may be - for standard input.")
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
}

void require_consistent(const PlotRequest& request) {
  const Names kinds{stroke_kind, period_kind, separation_kind, speed_kind};
  if (request.kind.empty()) {
    throw InputError("KIND", fmt::format("none given; there are {}", fmt::join(kinds, ", ")));
  }
  require_name("KIND", request.kind, kinds);
  const bool is_stroke = request.kind == stroke_kind, is_speed = request.kind == speed_kind;
  const auto refuse = [&](const std::string& flag) {
    throw InputError(flag, fmt::format("has no meaning for {}; leave it out", request.kind));
  };
  if ((is_stroke || is_speed) && !request.relative_to.empty()) refuse("--relative-to");
  if ((is_stroke || is_speed) && request.axes != "auto") refuse("--axes");
  if (!is_speed && !request.reference.empty()) refuse("--reference");
  if (is_speed && request.reference.empty()) {
    throw InputError("--reference", "none given; name a prediction or a run from which errors are measured");
  }
  if (!is_stroke && request.against != "cycle") refuse("--against");
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

}  // namespace beadswim
