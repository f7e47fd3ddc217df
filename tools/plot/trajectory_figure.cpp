#include "trajectory_figure.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/scene/units.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

constexpr std::size_t most_curves = 12;  // that the legend has room for, and eyes can tell apart

std::vector<TrajectoryFile> open_all(const std::vector<std::string>& paths) {
  if (paths.empty()) throw InputError("FILES", "no file given; name trajectories (.h5md) to draw");
  std::vector<TrajectoryFile> files;
  for (const std::string& path : paths) files.push_back(open_trajectory(path));
  for (const TrajectoryFile& file : files) {
    if (same_units(file.layout.units, files.front().layout.units)) continue;
    throw InputError(
        file.source,
        fmt::format("is in other units than {}; one figure holds one system of units", files.front().source));
  }
  return files;
}

/// A bead of the file, and its curve as it grows.
struct Curve {
  std::size_t bead = 0;  ///< index in the trajectory
  Series series;
};

std::vector<int> wanted_swimmers(const TrajectoryFile& file, const TrajectoryFigureOptions& options) {
  return options.swimmers.empty() ? file.swimmers() : options.swimmers;
}

std::size_t first_bead(const TrajectoryFile& file, int swimmer) {
  const std::vector<int>& of_bead = file.reader.header().swimmer;
  const auto found = std::ranges::find(of_bead, swimmer);
  if (found == of_bead.end()) refuse_swimmer("--swimmers", swimmer, file.swimmers(), file.source);
  return static_cast<std::size_t>(found - of_bead.begin());
}

/// "run, swimmer 0, bead 2", without what all curves share.
std::string curve_label(const TrajectoryFile& file, bool several_files, int swimmer, int bead,
                        bool several_beads) {
  std::string label = fmt::format("swimmer {}", swimmer);
  if (several_files) label = std::filesystem::path(file.source).stem().string() + ", " + label;
  if (several_beads) label += fmt::format(", bead {}", bead);
  return label;
}

/// Colours tell swimmers apart and dashes their beads; beads of one swimmer alone have colours, and swimmers
/// of one bead each have dashes too, so that no curve hides another.
std::vector<Curve> curves_of(const std::vector<TrajectoryFile>& files, std::size_t index,
                             const TrajectoryFigureOptions& options) {
  const TrajectoryFile& file = files[index];
  const std::vector<int> swimmers = wanted_swimmers(file, options);
  std::vector<Curve> curves;
  for (std::size_t s = 0; s < swimmers.size(); ++s) {
    const int place = static_cast<int>(index * swimmers.size() + s);
    const bool alone = files.size() * swimmers.size() == 1, one_bead = options.beads.size() == 1;
    for (std::size_t b = 0; b < options.beads.size(); ++b) {
      const int bead = options.beads[b], order = static_cast<int>(b);
      curves.push_back({first_bead(file, swimmers[s]) + static_cast<std::size_t>(bead - 1),
                        {.label = curve_label(file, files.size() > 1, swimmers[s], bead, !one_bead),
                         .mark = Mark::line,
                         .colour = alone ? order : place,
                         .dash = alone ? 0 : (one_bead ? place : order)}});
    }
  }
  return curves;
}

void trace(const TrajectoryFile& file, int axis, std::vector<Curve>& curves) {
  for (std::size_t n = 0; n < file.reader.frames(); ++n) {
    const TrajectoryFrame frame = file.reader.frame(n);
    for (Curve& curve : curves) {
      curve.series.x.push_back(frame.time / file.period());
      curve.series.y.push_back(frame.positions[curve.bead][axis]);
    }
  }
}

void require_few(std::size_t curves) {
  if (curves <= most_curves) return;
  throw InputError("--swimmers",
                   fmt::format("{} curves, but at most {} can be told apart; name fewer swimmers "
                               "or beads",
                               curves, most_curves));
}

std::string space_of(const TrajectoryFile& file) {
  if (!file.layout.domain) return "open space";
  const Vec3& box = file.layout.domain->lengths;
  return fmt::format("box {:g} × {:g} × {:g}", box.x(), box.y(), box.z());
}

std::string note_on(const TrajectoryFile& file) {
  const double end = file.reader.frame(file.reader.frames() - 1).time / file.period();
  return fmt::format("{}: {} swimmer{}, T = {:g}, {}; {:.4g} cycles",
                     std::filesystem::path(file.source).stem().string(), file.swimmers().size(),
                     file.swimmers().size() == 1 ? "" : "s", file.period(), space_of(file), end);
}

std::string title_of(const TrajectoryFigureOptions& options) {
  constexpr std::array names{"First", "Middle", "Last"};
  const std::string which =
      options.beads.size() == 1 ? fmt::format("{} beads", names[options.beads[0] - 1]) : "Beads";
  return fmt::format("{} along {}", which, "xyz"[options.axis]);
}

}  // namespace

Figure trajectory_figure(const std::vector<std::string>& paths, const TrajectoryFigureOptions& options) {
  const std::vector<TrajectoryFile> files = open_all(paths);
  std::size_t swimmers = 0;
  for (const TrajectoryFile& file : files) swimmers += wanted_swimmers(file, options).size();
  require_few(swimmers * options.beads.size());
  Panel panel{.x_label = {"time", "cycles of the driving"},
              .y_label = {std::string(1, "xyz"[options.axis]), length_unit(files.front().layout.units)}};
  std::vector<std::string> notes;
  for (std::size_t f = 0; f < files.size(); ++f) {
    std::vector<Curve> curves = curves_of(files, f, options);
    trace(files[f], options.axis, curves);
    for (Curve& curve : curves) panel.series.push_back(std::move(curve.series));
    notes.push_back(note_on(files[f]));
  }
  return {.title = title_of(options), .panels = {std::move(panel)}, .notes = std::move(notes)};
}

}  // namespace beadswim
