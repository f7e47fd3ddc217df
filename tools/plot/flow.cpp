#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/documents/trajectory_file.hpp"
#include "beadswim/scene/units.hpp"
#include "flow_field.hpp"
#include "kinds.hpp"
#include "plot_labels.hpp"

// Pictures of the flow in a plane, which is read from a flow file or from the flow files of a run.

namespace beadswim {
namespace {

namespace fs = std::filesystem;

struct FlowFlags {
  FlowPlane plane{};
  FlowQuantity quantity = FlowQuantity::speed;
  FlowStyle style = FlowStyle::streamlines;
};

/// Flow files of one time, and the run that wrote them.
struct FlowSource {
  std::vector<std::string> files;
  std::optional<double> time{};         ///< nullopt: unknown [time]
  std::optional<TrajectoryFile> run{};  ///< nullopt: unknown
};

/// Returns the files of one time in an index of flow files, such as run.h5md.flow.pvd.
FlowSource flow_at(double time, const std::string& index, const std::vector<PvdEntry>& entries) {
  FlowSource source{.files = {}, .time = time};
  for (const PvdEntry& entry : entries)
    if (entry.time == time) source.files.push_back(fs::path(index).parent_path() / entry.file);
  return source;
}

/// Returns the flow of a run at the last time for which it has written it.
FlowSource last_flow(const std::string& path) {
  const std::string part = ".part",
                    stem = path.ends_with(part) ? path.substr(0, path.size() - part.size()) : path;
  const std::string index = stem + ".flow.pvd";
  std::error_code ignored;
  const std::vector<PvdEntry> entries =
      fs::exists(index, ignored) ? read_pvd(index) : std::vector<PvdEntry>{};
  if (entries.empty())
    throw InputError(
        path, "this run has written no flow to {}; run it with --flow-every, or give a flow file (.vti)",
        index);
  FlowSource source = flow_at(entries.back().time, index, entries);
  source.run = open_trajectory(path);
  return source;
}

/// Returns the flow of a file. If the index beside its folder RUN.flow lists it, it belongs to the trajectory
/// RUN, and all files of its time are drawn.
FlowSource flow_file(const std::string& path) {
  std::error_code ignored;
  const std::string folder = fs::absolute(path).parent_path(), index = folder + ".pvd";
  if (!folder.ends_with(".flow") || !fs::exists(index, ignored)) return {.files = {path}};
  const std::vector<PvdEntry> entries = read_pvd(index);
  const auto is_here = [&](const PvdEntry& entry) {
    return fs::path(entry.file).filename() == fs::path(path).filename();
  };
  const auto entry = std::ranges::find_if(entries, is_here);
  if (entry == entries.end()) return {.files = {path}};
  FlowSource source = flow_at(entry->time, index, entries);
  const std::string run = folder.substr(0, folder.rfind(".flow"));
  for (const std::string& trajectory : {run, run + ".part"})
    if (fs::exists(trajectory, ignored) && !source.run) source.run = open_trajectory(trajectory);
  return source;
}

/// Returns the positions of the beads at a time, interpolated between frames; empty if there are no frames
/// around it.
std::vector<Vec3> positions_at(const TrajectoryReader& reader, double time) {
  constexpr double roundoff = 1e-9;
  const std::vector<double> times = reader.times();
  const auto after = std::ranges::lower_bound(times, time * (1 - roundoff));
  if (after == times.end()) return {};
  const std::size_t next = after - times.begin();
  std::vector<Vec3> positions = reader.frame(next).positions;
  if (times[next] <= time * (1 + roundoff)) return positions;
  if (next == 0) return {};
  const std::vector<Vec3> before = reader.frame(next - 1).positions;
  const double weight = (times[next] - time) / (times[next] - times[next - 1]);
  for (std::size_t b = 0; b < positions.size(); ++b) positions[b] += weight * (before[b] - positions[b]);
  return positions;
}

/// Returns, for each periodic copy of a bead that reaches into the extent, the displacement from the bead:
/// across the plane only the copy nearest to it.
std::vector<Vec3> copies_of(const Vec3& centre, double radius, const std::optional<Box>& box,
                            const Eigen::AlignedBox3d& extent, const FlowPlane& plane) {
  std::vector<Vec3> copies{Vec3::Zero()};
  for (int a = 0; a < 3; ++a) {
    const double length = box && box->is_periodic(a) ? box->lengths[a] : 0;
    const double low = extent.min()[a] - radius - centre[a], high = extent.max()[a] + radius - centre[a];
    std::vector<double> shifts{0};
    if (length > 0 && a == plane.across)
      shifts = {length * std::round((*plane.coordinate - centre[a]) / length)};
    if (length > 0 && a != plane.across) {
      shifts.clear();
      for (double n = std::ceil(low / length); n * length <= high; ++n) shifts.push_back(n * length);
    }
    std::vector<Vec3> all;
    for (const Vec3& copy : copies)
      for (const double shift : shifts)
        if (a == plane.across || (shift >= low && shift <= high)) all.push_back(copy + shift * Vec3::Unit(a));
    copies = std::move(all);
  }
  return copies;
}

/// Returns the outlines of the beads of a run. Beads that the plane does not cut are projected on it if it
/// cuts another bead of their swimmer, or if it cuts no bead at all.
std::vector<BeadOutline> outlines(const FlowSource& source, const FlowPicture& picture,
                                  const Eigen::AlignedBox3d& extent) {
  const TrajectoryHeader& header = source.run->reader.header();
  const std::vector<Vec3> positions = positions_at(source.run->reader, *source.time);
  const FlowPlane plane{picture.across, picture.coordinate};
  const auto [right, up] = picture.axes();
  std::vector<std::pair<int, BeadOutline>> all;  // with the ids of the swimmers
  std::set<int> cut_swimmers;
  for (std::size_t b = 0; b < positions.size(); ++b)
    for (const Vec3& copy :
         copies_of(positions[b], header.radius[b], source.run->layout.domain.box, extent, plane)) {
      const Vec3 centre = positions[b] + copy;
      const double radius = header.radius[b], depth = centre[picture.across] - picture.coordinate;
      const bool is_cut = std::abs(depth) < radius;
      if (is_cut) cut_swimmers.insert(header.swimmer[b]);
      all.emplace_back(header.swimmer[b],
                       BeadOutline{.centre = {centre[right], centre[up]},
                                   .radius = is_cut ? std::sqrt(radius * radius - depth * depth) : radius,
                                   .is_cut = is_cut});
    }
  std::vector<BeadOutline> drawn;
  for (const auto& [swimmer, outline] : all)
    if (cut_swimmers.empty() || cut_swimmers.contains(swimmer)) drawn.push_back(outline);
  return drawn;
}

std::string scene_text(const FlowSource& source, const FlowPicture& picture,
                       const std::optional<int>& frame_swimmer) {
  std::string text = fmt::format("Plane {} = {:g}", "xyz"[picture.across], picture.coordinate);
  if (frame_swimmer) text += fmt::format(" in the frame of swimmer {}", *frame_swimmer);
  if (!source.run) return text;
  const std::size_t swimmers = source.run->swimmers().size();
  return text + fmt::format("; {} swimmer{}, T = {:g}, {}", swimmers, swimmers == 1 ? "" : "s",
                            source.run->period(), in_words(source.run->layout.domain));
}

std::string reading_text(const FlowPicture& picture) {
  std::string text = picture.style == FlowStyle::streamlines
                         ? "Streamlines follow the velocity in the plane."
                         : "Arrows show the velocity in the plane; their length grows as its square root.";
  const auto is_cut = [](const BeadOutline& bead) { return bead.is_cut; };
  if (picture.shows_covered_cells) return text + " Beads are grey.";
  if (picture.beads.empty()) return text;
  if (std::ranges::any_of(picture.beads, is_cut)) text += " Circles are sections of beads.";
  if (!std::ranges::all_of(picture.beads, is_cut))
    text += " Dashed circles are beads in front of the plane or behind it.";
  return text;
}

FlowPicture flow_figure(const std::vector<std::string>& inputs, const FlowFlags& options) {
  const std::string path =
      only_file(inputs, "a flow is drawn from one flow file (.vti) or one trajectory (.h5md)");
  const FlowSource source = is_trajectory(path) ? last_flow(path) : flow_file(path);
  const FlowField field(source.files);
  const FlowPlane plane = field.resolved(options.plane);
  const std::optional<int>& mean_cycles = field.cells().mean_cycles;
  const std::optional<int>& frame_swimmer = field.cells().frame_swimmer;
  FlowPicture picture{
      .title = mean_cycles ? fmt::format("Mean flow of {}", cycles_text({static_cast<double>(*mean_cycles)}))
                           : "Flow",
      .across = *plane.across,
      .coordinate = *plane.coordinate,
      .layers = field.layers(plane),
      .quantity = options.quantity,
      .style = options.style};
  if (source.run) {
    picture.length_unit = length_unit(source.run->layout.units);
    picture.velocity_unit = velocity_unit(source.run->layout.units);
    if (source.time) {
      picture.title += fmt::format(" after {}", cycles_text({*source.time / source.run->period()}));
      if (!mean_cycles && !frame_swimmer) picture.beads = outlines(source, picture, field.extent());
    }
  }
  const auto has_covered = [](const FlowLayer& layer) { return std::ranges::max(layer.covered) >= 0.5; };
  picture.shows_covered_cells = picture.beads.empty() && std::ranges::any_of(picture.layers, has_covered);
  picture.notes = {{.text = scene_text(source, picture, frame_swimmer)}, {.text = reading_text(picture)}};
  return picture;
}

/// Parses a plane: "xz", or "xz:COORDINATE". Throws InputError if the text has another form.
FlowPlane parse_plane(const std::string& text) {
  FlowPlane plane;
  const std::string name = text.substr(0, text.find(':'));
  const std::array<std::string, 3> planes{"yz", "xz", "xy"};
  plane.across = static_cast<int>(std::ranges::find(planes, name) - planes.begin());
  const std::string coordinate = name == text ? "0" : text.substr(name.size() + 1);
  if (*plane.across == 3 || !number_list({1}, finite())(coordinate).empty())
    throw InputError("--plane",
                     "\"{}\": the value must be xy, xz or yz, with a coordinate if wanted, such as xz:12.5",
                     text);
  if (name != text) plane.coordinate = parse_numbers(coordinate).front();
  return plane;
}

}  // namespace

DrawFigure add_flow_flags(CLI::App& command) {
  const auto options = std::make_shared<FlowFlags>();
  const auto take_plane = [options](const std::string& text) { options->plane = parse_plane(text); };
  add_value(
      command, "--plane", take_plane, {.name = "xy|xz|yz[:COORDINATE]", .initial = "xy"},
      "Plane to draw, and its place along the axis across it, which is by default the middle of the flow. "
      "A flow with one layer of cells is drawn in its own plane");
  add_choice(command, "--quantity", options->quantity,
             "Quantity that the colours show: the magnitude of the velocity, or one component of it");
  add_choice(command, "--style", options->style, "Lines or arrows that show the velocity in the plane");
  return [options](const PlotFiles& files) { return draw(flow_figure(files.inputs, *options)); };
}

}  // namespace beadswim
