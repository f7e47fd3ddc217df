#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <set>

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

struct TrajectoryFlags {
  std::vector<int> swimmers;  ///< ids; empty: all swimmers
  std::vector<int> beads{2};  ///< numbers from 1
  int axis = 0;               ///< coordinate that is drawn: 0, 1, 2 for x, y, z
};

constexpr std::size_t max_curves = 12;  // readers cannot distinguish more curves

std::vector<TrajectoryFile> open_all(const std::vector<std::string>& paths) {
  if (paths.empty()) throw InputError("FILES", "no file is given; name trajectories (.h5md) to draw");
  std::vector<TrajectoryFile> files;
  for (const std::string& path : paths) files.push_back(open_trajectory(path));
  for (const TrajectoryFile& file : files) {
    if (same_units(file.layout.units, files.front().layout.units)) continue;
    throw InputError(file.source, fmt::format("the units of this file differ from the units of {}; all files "
                                              "of a figure must have the same units",
                                              files.front().source));
  }
  return files;
}

std::vector<int> selected_swimmers(const TrajectoryFile& file, const TrajectoryFlags& options) {
  return options.swimmers.empty() ? file.swimmers() : options.swimmers;
}

/// Returns the index of a bead of a swimmer in the trajectory. Throws InputError if the trajectory has no
/// such swimmer, or if the swimmer has fewer beads.
std::size_t bead_index(const TrajectoryFile& file, int swimmer, int bead) {
  const std::vector<int>& of_bead = file.reader.header().swimmer;
  const auto found = std::ranges::find(of_bead, swimmer);
  if (found == of_bead.end()) throw_unknown_swimmer("--swimmers", swimmer, file.swimmers(), file.source);
  const auto index = found - of_bead.begin() + bead - 1;
  if (index >= std::ssize(of_bead) || of_bead[index] != swimmer)
    throw InputError(
        "--beads", fmt::format("swimmer {} in {} has no bead {}; its beads have the numbers 1 to {}", swimmer,
                               file.source, bead, std::ranges::count(of_bead, swimmer)));
  return static_cast<std::size_t>(index);
}

/// Returns the label of a curve, such as "run, swimmer 0, bead 2". Omits the file or the bead if all curves
/// have the same.
std::string curve_label(const TrajectoryFile& file, bool several_files, int swimmer, int bead,
                        bool several_beads) {
  std::string label = fmt::format("swimmer {}", swimmer);
  if (several_files) label = std::filesystem::path(file.source).stem().string() + ", " + label;
  if (several_beads) label += fmt::format(", bead {}", bead);
  return label;
}

/// Returns the curves of a file, sorted by swimmer and then by bead.
std::vector<Series> curves_of(const TrajectoryFile& file, bool several_files, const TrajectoryFlags& flags) {
  std::vector<std::size_t> beads;  // indices in the trajectory
  std::vector<Series> curves;
  for (const int swimmer : selected_swimmers(file, flags)) {
    for (const int bead : flags.beads) {
      beads.push_back(bead_index(file, swimmer, bead));
      curves.push_back({curve_label(file, several_files, swimmer, bead, flags.beads.size() > 1)});
    }
  }
  for (std::size_t n = 0; n < file.reader.frames(); ++n) {
    const TrajectoryFrame frame = file.reader.frame(n);
    for (std::size_t c = 0; c < curves.size(); ++c) {
      curves[c].x.push_back(frame.time / file.period());
      curves[c].y.push_back(frame.positions[beads[c]][flags.axis]);
    }
  }
  return curves;
}

void require_few(std::size_t curves) {
  if (curves <= max_curves) return;
  throw InputError("--swimmers", fmt::format("the figure would have {} curves, but at most {} can be "
                                             "distinguished; name fewer swimmers or beads",
                                             curves, max_curves));
}

std::string space_of(const TrajectoryFile& file) {
  if (!file.layout.domain) return "open space";
  const Vec3& box = file.layout.domain->lengths;
  return fmt::format("box {:g} × {:g} × {:g}", box.x(), box.y(), box.z());
}

/// Returns a note that states the scenes and the lengths of all trajectories, with ranges where they differ.
Note scenes_note(const std::vector<TrajectoryFile>& files) {
  std::vector<double> swimmers, periods, cycles;
  std::set<std::string> spaces;
  for (const TrajectoryFile& file : files) {
    swimmers.push_back(static_cast<double>(file.swimmers().size()));
    periods.push_back(file.period());
    cycles.push_back(file.reader.frame(file.reader.frames() - 1).time / file.period());
    spaces.insert(space_of(file));
  }
  const std::string count = range_text(swimmers, 6);
  return {.text = fmt::format("{} swimmer{}, T = {}, {}; {} cycles", count, count == "1" ? "" : "s",
                              range_text(periods, 6),
                              spaces.size() == 1 ? *spaces.begin() : fmt::format("{} boxes", spaces.size()),
                              range_text(cycles, 4))};
}

std::string title_of(const TrajectoryFlags& options) {
  constexpr std::array names{"First", "Middle", "Last"};
  const std::string which = options.beads.size() > 1 ? "Beads"
                            : options.beads[0] <= std::ssize(names)
                                ? fmt::format("{} beads", names[options.beads[0] - 1])
                                : fmt::format("Beads {}", options.beads[0]);
  return fmt::format("{} along {}", which, "xyz"[options.axis]);
}

Figure trajectory_figure(const std::vector<std::string>& paths, const TrajectoryFlags& options) {
  const std::vector<TrajectoryFile> files = open_all(paths);
  std::size_t swimmers = 0;
  for (const TrajectoryFile& file : files) swimmers += selected_swimmers(file, options).size();
  require_few(swimmers * options.beads.size());
  Panel panel{.x_label = {"time", "cycles of the driving"},
              .y_label = {std::string(1, "xyz"[options.axis]), length_unit(files.front().layout.units)}};
  for (const TrajectoryFile& file : files)
    std::ranges::move(curves_of(file, files.size() > 1, options), std::back_inserter(panel.series));
  style_bead_curves(static_cast<int>(options.beads.size()), panel.series);
  return {.title = title_of(options),
          .panels = {std::move(panel)},
          .notes = {{.text = "Coordinates are not wrapped into the box. The mean slope over a cycle is the "
                             "velocity, mean flow included."},
                    scenes_note(files)}};
}

}  // namespace

Drawing add_trajectory_flags(CLI::App& command) {
  const auto options = std::make_shared<TrajectoryFlags>();
  add_whole_numbers(command, "--swimmers", options->swimmers, "all", "Ids of the swimmers to draw");
  command
      .add_option_function<std::string>(
          "--beads", [options](const std::string& text) { options->beads = parse_whole_numbers(text); },
          "Beads of each swimmer to draw, 1 to 3 along the axis of a three-bead swimmer")
      ->type_name("1|2|3,...")
      ->check(number_list({}, whole_number(1, max_beads)))
      ->default_str("2");
  add_word(command, "--along", {"x", "y", "z"}, "x", "Coordinate to draw, not wrapped into the box",
           [options](const std::string& word) { options->axis = word[0] - 'x'; });
  return
      [options](const PlotFiles& files) { return figure_to_svg(trajectory_figure(files.inputs, *options)); };
}

}  // namespace beadswim
