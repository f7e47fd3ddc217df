#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <set>
#include <span>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/figure/figure.hpp"
#include "beadswim/scene/units.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

struct TrajectoryFlags {
  std::vector<int> swimmers;  ///< ids; empty: all swimmers
  std::vector<int> beads;     ///< numbers from 1; empty: the middle bead of each swimmer
  int axis = 0;               ///< coordinate that is drawn: 0, 1, 2 for x, y, z
  /// The abscissa is the angle of the swimmer's axis to the plane across this coordinate, not the time.
  bool against_angle = false;

  std::size_t beads_per_swimmer() const { return std::max<std::size_t>(1, beads.size()); }
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

/// Returns the number of the middle one of `beads` beads.
int middle_bead(int beads) {
  return beads / 2 + 1;
}

/// Returns the angle of a swimmer's axis to the plane across a coordinate [degree].
double angle_of(const TrajectoryFile& file, std::size_t swimmer, const TrajectoryFrame& frame,
                int coordinate) {
  const std::size_t first = file.reader.header().first_beads()[swimmer];
  const SwimmerType& type = file.type(swimmer);
  const std::span<const Vec3> beads(&frame.positions[first], type.beads.size());
  const Vec3 axis = axis_of(type, beads, file.layout.swimmers[file.in_layout[swimmer]].orientation());
  return std::asin(std::clamp(axis[coordinate], -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// Returns the curves of a file, sorted by swimmer and then by bead, with labels such as "run, swimmer 0,
/// bead 2". A label omits the file if there is only one. Throws InputError if the trajectory has no such
/// swimmer, or if a swimmer has fewer beads.
std::vector<Series> curves_of(const TrajectoryFile& file, bool several_files, const TrajectoryFlags& flags) {
  const std::vector<int> ids = file.swimmers();
  std::vector<std::size_t> swimmers, beads;  // indices in the trajectory, of each curve
  std::vector<Series> curves;
  for (const int id : flags.swimmers.empty() ? ids : flags.swimmers) {
    const std::size_t swimmer = swimmer_with_id(id, ids, "--swimmers", file.source);
    const int num_beads = static_cast<int>(file.type(swimmer).beads.size());
    std::string label = fmt::format("swimmer {}", id);
    if (several_files) label = std::filesystem::path(file.source).stem().string() + ", " + label;
    for (const int bead : flags.beads.empty() ? std::vector{middle_bead(num_beads)} : flags.beads) {
      if (bead > num_beads)
        throw InputError("--beads", "swimmer {} in {} has no bead {}; its beads have the numbers 1 to {}", id,
                         file.source, bead, num_beads);
      swimmers.push_back(swimmer);
      beads.push_back(file.reader.header().first_beads()[swimmer] + static_cast<std::size_t>(bead) - 1);
      curves.push_back({flags.beads.size() > 1 ? fmt::format("{}, bead {}", label, bead) : label});
    }
  }
  for (std::size_t n = 0; n < file.reader.frames(); ++n) {
    const TrajectoryFrame frame = file.reader.frame(n);
    const double cycles = frame.time / file.period();
    if (flags.against_angle && !whole_cycles(frame.time, file.period())) continue;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      curves[c].x.push_back(flags.against_angle ? angle_of(file, swimmers[c], frame, flags.axis) : cycles);
      curves[c].y.push_back(frame.positions[beads[c]][flags.axis]);
    }
  }
  return curves;
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
Note reading_note(const std::vector<TrajectoryFile>& files, const TrajectoryFlags& flags) {
  const auto is_wrapped = [&](const TrajectoryFile& file) {
    return file.layout.domain.box && file.layout.domain.box->is_periodic(flags.axis);
  };
  std::vector<std::string> texts;
  if (flags.against_angle) texts.emplace_back("Points at the ends of cycles.");
  if (std::ranges::any_of(files, is_wrapped)) texts.emplace_back("Coordinates are not wrapped into the box.");
  if (!flags.against_angle)
    texts.emplace_back("The mean slope over a cycle is the velocity, mean flow included.");
  return {.text = joined(texts, " ")};
}

/// Sets the styles of curves, which are sorted by swimmer and then by bead. The colour identifies the
/// swimmer, and the dash pattern identifies the bead. If there is only one swimmer, colours identify its
/// beads. If there is one bead per swimmer, each swimmer also has its own dash pattern, so that coinciding
/// curves remain visible. The lines of a long figure are solid, each in its own colour: dashes would look
/// like slow oscillations.
void set_styles(std::size_t num_beads, bool is_long, std::vector<Series>& curves) {
  const bool one_swimmer = curves.size() == num_beads;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::size_t swimmer = c / num_beads, bead = c % num_beads;
    curves[c].mark = Mark::line;
    curves[c].colour = static_cast<int>(is_long ? c : one_swimmer ? bead : swimmer);
    curves[c].dash = static_cast<int>(is_long || one_swimmer ? 0 : num_beads == 1 ? swimmer : bead);
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
  const auto is_long_file = [](const TrajectoryFile& file) {
    return file.reader.times().back() > max_dashed * file.period();
  };
  const bool is_long = !options.against_angle && std::ranges::any_of(files, is_long_file);
  std::size_t curves = 0;
  for (const TrajectoryFile& file : files)
    curves += options.beads_per_swimmer() *
              (options.swimmers.empty() ? file.in_layout.size() : options.swimmers.size());
  if (const std::size_t limit = is_long ? max_solid : max_curves; curves > limit)
    throw InputError(
        "--swimmers",
        "the figure would have {} curves, but at most {} can be distinguished; name fewer swimmers or beads",
        curves, limit);
  const char axis = "xyz"[options.axis];
  Panel panel{.x_label = {"time", "cycles of the driving"},
              .y_label = {std::string(1, axis), length_unit(files.front().layout.units)}};
  if (options.against_angle)
    panel.x_label = {fmt::format("angle of the axis to the plane across {}", axis), "degrees"};
  for (const TrajectoryFile& file : files)
    std::ranges::move(curves_of(file, files.size() > 1, options), std::back_inserter(panel.series));
  set_styles(options.beads_per_swimmer(), is_long, panel.series);
  return {.title = title_of(files, options),
          .panels = {std::move(panel)},
          .notes = {reading_note(files, options), scenes_note(files)}};
}

}  // namespace

DrawFigure add_trajectory_flags(CLI::App& command) {
  const auto options = std::make_shared<TrajectoryFlags>();
  add_swimmers(command, options->swimmers, "ID,...", "all", "Ids of the swimmers to draw");
  add_list(command, "--beads", options->beads,
           {"N,...", number_list({}, whole_number(1, max_beads)), "the middle bead"},
           "Numbers of the beads of each swimmer to draw, from 1");
  add_word(command, "--along", {"x", "y", "z"}, "x", "Coordinate to draw, not wrapped into the box",
           [options](const std::string& word) { options->axis = word[0] - 'x'; });
  add_word(
      command, "--against", {"time", "angle"}, "time",
      "Abscissa: time, or the angle of the swimmer's axis to the plane across the coordinate, such as a wall",
      [options](const std::string& word) { options->against_angle = word == "angle"; });
  return [options](const PlotFiles& files) { return draw(trajectory_figure(files.inputs, *options)); };
}

}  // namespace beadswim
