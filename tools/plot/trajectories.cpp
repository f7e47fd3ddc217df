#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <span>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/figure/curves.hpp"
#include "beadswim/scene/units.hpp"
#include "flags.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

/// Abscissa of the figure.
enum class Against {
  time,
  angle,  ///< of the swimmer's axis to the plane across the coordinate that is drawn
};

struct TrajectoryFlags {
  std::vector<int> swimmers;  ///< ids; empty: all swimmers
  std::vector<int> beads;     ///< numbers from 1; empty: the middle bead of each swimmer
  int axis = 0;               ///< coordinate that is drawn: 0, 1, 2 for x, y, z
  Against against = Against::time;
};

constexpr std::size_t max_curves = 12;  // readers cannot distinguish more curves
constexpr std::size_t max_solid = 7;    // colours that readers can distinguish
constexpr double max_dashed = 30;       // cycles in which dashes can be distinguished from oscillations

std::vector<TrajectoryFile> open_all(const std::vector<std::string>& paths) {
  if (paths.empty()) throw InputError("FILES", "no file is given; name trajectories (.h5md) to draw");
  std::vector<TrajectoryFile> files;
  for (const std::string& path : paths) files.push_back(open_trajectory(path));
  for (const TrajectoryFile& file : files)
    require_same_units(file.layout.units, file.source, files.front().layout.units, files.front().source);
  return files;
}

std::vector<int> selected_swimmers(const TrajectoryFile& file, const TrajectoryFlags& options) {
  return options.swimmers.empty() ? file.swimmers() : options.swimmers;
}

/// Returns the number of the middle one of `beads` beads.
int middle_bead(int beads) {
  return beads / 2 + 1;
}

/// Returns the indices of the selected beads of a swimmer in the trajectory. Throws InputError if the
/// trajectory has no such swimmer, or if the swimmer has fewer beads.
std::vector<std::size_t> bead_indices(const TrajectoryFile& file, int swimmer, std::vector<int> selected) {
  const std::vector<int>& of_bead = file.reader.header().swimmer;
  const auto first = std::ranges::find(of_bead, swimmer);
  if (first == of_bead.end()) throw_unknown_swimmer("--swimmers", swimmer, file.swimmers(), file.source);
  const auto beads = static_cast<int>(std::ranges::count(of_bead, swimmer));
  if (selected.empty()) selected = {middle_bead(beads)};
  std::vector<std::size_t> indices;
  for (const int bead : selected) {
    if (bead > beads)
      throw InputError("--beads",
                       fmt::format("swimmer {} in {} has no bead {}; its beads have the numbers 1 to {}",
                                   swimmer, file.source, bead, beads));
    indices.push_back(static_cast<std::size_t>(first - of_bead.begin() + bead - 1));
  }
  return indices;
}

int beads_per_swimmer(const TrajectoryFlags& flags) {
  return flags.beads.empty() ? 1 : static_cast<int>(flags.beads.size());
}

/// Returns the label of a curve, such as "run, swimmer 0, bead 2". Omits the file if there is only one.
/// `bead`: nullopt to omit the bead.
std::string curve_label(const TrajectoryFile& file, bool several_files, int swimmer,
                        std::optional<int> bead) {
  std::string label = fmt::format("swimmer {}", swimmer);
  if (several_files) label = std::filesystem::path(file.source).stem().string() + ", " + label;
  if (bead) label += fmt::format(", bead {}", *bead);
  return label;
}

/// Returns the angle of a swimmer's axis to the plane across a coordinate [degree].
double angle_of(const TrajectoryFile& file, int swimmer, const TrajectoryFrame& frame, int coordinate) {
  const std::vector<int> ids = file.swimmers();
  const std::size_t index = std::ranges::find(ids, swimmer) - ids.begin();
  const std::size_t first = file.reader.header().first_beads()[index];
  const SwimmerType& type = file.type(index);
  const std::span<const Vec3> beads(&frame.positions[first], type.beads.size());
  const Vec3 axis = axis_of(type, beads, file.layout.swimmers[file.in_layout[index]].orientation());
  return std::asin(std::clamp(axis[coordinate], -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// Returns the curves of a file, sorted by swimmer and then by bead.
std::vector<Series> curves_of(const TrajectoryFile& file, bool several_files, const TrajectoryFlags& flags) {
  std::vector<std::size_t> beads;  // indices in the trajectory
  std::vector<int> swimmers;       // of each curve
  std::vector<Series> curves;
  for (const int swimmer : selected_swimmers(file, flags)) {
    std::ranges::copy(bead_indices(file, swimmer, flags.beads), std::back_inserter(beads));
    swimmers.insert(swimmers.end(), beads_per_swimmer(flags), swimmer);
    for (int i = 0; i < beads_per_swimmer(flags); ++i)
      curves.push_back({curve_label(file, several_files, swimmer,
                                    flags.beads.size() > 1 ? std::optional(flags.beads[i]) : std::nullopt)});
  }
  for (std::size_t n = 0; n < file.reader.frames(); ++n) {
    const TrajectoryFrame frame = file.reader.frame(n);
    const double cycles = frame.time / file.period();
    constexpr double roundoff = 1e-6;
    if (flags.against == Against::angle && std::abs(cycles - std::round(cycles)) > roundoff) continue;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      curves[c].x.push_back(flags.against == Against::time ? cycles
                                                           : angle_of(file, swimmers[c], frame, flags.axis));
      curves[c].y.push_back(frame.positions[beads[c]][flags.axis]);
    }
  }
  return curves;
}

void require_few(std::size_t curves, std::size_t max_curves) {
  if (curves <= max_curves) return;
  throw InputError("--swimmers", fmt::format("the figure would have {} curves, but at most {} can be "
                                             "distinguished; name fewer swimmers or beads",
                                             curves, max_curves));
}

/// Returns a note that states the scenes and the lengths of all trajectories, with ranges where they differ.
Note scenes_note(const std::vector<TrajectoryFile>& files) {
  std::vector<double> swimmers, periods, cycles;
  std::set<std::string> spaces;
  for (const TrajectoryFile& file : files) {
    swimmers.push_back(static_cast<double>(file.swimmers().size()));
    periods.push_back(file.period());
    cycles.push_back(file.reader.frame(file.reader.frames() - 1).time / file.period());
    spaces.insert(in_words(file.layout.domain));
  }
  const std::string count = range_text(swimmers, 6);
  return {.text = fmt::format("{} swimmer{}, T = {}, {}; {}", count, count == "1" ? "" : "s",
                              range_text(periods, 6),
                              spaces.size() == 1 ? *spaces.begin() : fmt::format("{} boxes", spaces.size()),
                              cycles_text(cycles))};
}

/// Returns how to read the figure. Coordinates differ from wrapped ones only if a box is periodic.
Note reading_note(const std::vector<TrajectoryFile>& files, bool is_by_time, int axis) {
  const auto is_wrapped = [&](const TrajectoryFile& file) {
    return file.layout.domain.box && file.layout.domain.box->is_periodic(axis);
  };
  std::vector<std::string> texts;
  if (!is_by_time) texts.emplace_back("Points at the ends of cycles.");
  if (std::ranges::any_of(files, is_wrapped)) texts.emplace_back("Coordinates are not wrapped into the box.");
  if (is_by_time) texts.emplace_back("The mean slope over a cycle is the velocity, mean flow included.");
  return {.text = fmt::format("{}", fmt::join(texts, " "))};
}

/// Makes the lines of a long figure solid, each in its own colour: dashes would look like slow oscillations.
void make_solid(std::vector<Series>& curves) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    curves[c].colour = static_cast<int>(c);
    curves[c].dash = 0;
  }
}

/// Returns the place of a bead among the beads of its swimmer, or its number if it has no name.
std::string bead_name(int bead, int beads) {
  if (bead == 1) return "First beads";
  if (bead == beads) return "Last beads";
  return bead == middle_bead(beads) ? "Middle beads" : fmt::format("Beads {}", bead);
}

std::string title_of(const std::vector<TrajectoryFile>& files, const TrajectoryFlags& options) {
  std::set<std::string> names;
  for (const TrajectoryFile& file : files)
    for (const auto& [name, type] : file.layout.types)
      for (const int bead : options.beads) names.insert(bead_name(bead, static_cast<int>(type.beads.size())));
  const std::string which = options.beads.empty()      ? "Middle beads"
                            : options.beads.size() > 1 ? "Beads"
                            : names.size() > 1         ? fmt::format("Beads {}", options.beads[0])
                                                       : *names.begin();
  return fmt::format("{} along {}", which, "xyz"[options.axis]);
}

Figure trajectory_figure(const std::vector<std::string>& paths, const TrajectoryFlags& options) {
  const std::vector<TrajectoryFile> files = open_all(paths);
  std::size_t swimmers = 0;
  for (const TrajectoryFile& file : files) swimmers += selected_swimmers(file, options).size();
  const bool by_time = options.against == Against::time;
  const bool is_long = by_time && std::ranges::any_of(files, [](const TrajectoryFile& file) {
                         return file.reader.times().back() > max_dashed * file.period();
                       });
  require_few(swimmers * static_cast<std::size_t>(beads_per_swimmer(options)),
              is_long ? max_solid : max_curves);
  const std::string across = fmt::format("angle of the axis to the plane across {}", "xyz"[options.axis]);
  Panel panel{.x_label = by_time ? AxisLabel{"time", "cycles of the driving"} : AxisLabel{across, "degrees"},
              .y_label = {std::string(1, "xyz"[options.axis]), length_unit(files.front().layout.units)}};
  for (const TrajectoryFile& file : files)
    std::ranges::move(curves_of(file, files.size() > 1, options), std::back_inserter(panel.series));
  style_bead_curves(beads_per_swimmer(options), panel.series);
  if (is_long) make_solid(panel.series);
  return {.title = title_of(files, options),
          .panels = {std::move(panel)},
          .notes = {reading_note(files, by_time, options.axis), scenes_note(files)}};
}

}  // namespace

Drawing add_trajectory_flags(CLI::App& command) {
  const auto options = std::make_shared<TrajectoryFlags>();
  add_swimmers(command, options->swimmers, "Ids of the swimmers to draw")->default_str("all");
  add_whole_numbers(command, "--beads", options->beads, number_list({}, whole_number(1, max_beads)),
                    "Numbers of the beads of each swimmer to draw, from 1")
      ->type_name("N,...")
      ->default_str("the middle bead");
  add_word(command, "--along", {"x", "y", "z"}, "x", "Coordinate to draw, not wrapped into the box",
           [options](const std::string& word) { options->axis = word[0] - 'x'; });
  add_word(
      command, "--against", {"time", "angle"}, "time",
      "Abscissa: time, or the angle of the swimmer's axis to the plane across the coordinate, such as a wall",
      [options](const std::string& word) {
        options->against = word == "time" ? Against::time : Against::angle;
      });
  return [options](const PlotFiles& files) { return Drawn(trajectory_figure(files.inputs, *options)); };
}

}  // namespace beadswim
