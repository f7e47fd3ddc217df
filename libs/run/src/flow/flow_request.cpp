#include "beadswim/run/flow_request.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/io/json.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

using Region = Eigen::AlignedBox3d;

/// Largest number of places. Places, velocities and sums of a mean then need some 10 GB.
constexpr double max_places = 1e8;

/// Returns the finite number that the text is, up to spaces around it; nullopt if it is none.
std::optional<double> number_in(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

Region parse_region(const std::string& text) {
  Region region;
  const auto axes = split_at(',', text);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto ends = split_at(':', axes[a]);
    const auto low = number_in(ends.front()), high = number_in(ends.back());
    if (axes.size() != 3 || ends.size() != 2 || !low || !high || *low > *high)
      throw InputError(Setting::flow_region,
                       "\"{}\" is no region; give the ends of the three axes as X0:X1,Y0:Y1,Z0:Z1 with X0 "
                       "<= X1 (equal ends: one layer of cells)",
                       text);
    region.min()[a] = *low;
    region.max()[a] = *high;
  }
  return region;
}

/// Returns the part of space that the fluid fills.
Region fluid_of(const Domain& domain) {
  Region fluid(Vec3::Constant(-INFINITY), Vec3::Constant(INFINITY));
  if (domain.box) fluid = Region(Vec3::Zero(), domain.box->lengths);
  if (domain.half_space) fluid.min()[domain.half_space->axis] = 0;
  return fluid;
}

double swimmer_length(const SwimmerType& type) {
  double length = 0;
  for (int a = 0; a < 3; ++a) length = std::max(length, reach_of_surfaces(type, a).length());
  return length;
}

constexpr double usual_reach = 3;  // around swimmers, in lengths of the longest

/// Returns the box, or three lengths of a swimmer around all swimmers or around that of the frame.
Region usual_region(const FlowRequest& request, const Layout& layout) {
  double reach = 0;
  for (const Swimmer& swimmer : layout.swimmers)
    if (!request.swimmer || *request.swimmer == swimmer.id)
      reach = std::max(reach, usual_reach * swimmer_length(layout.types.at(swimmer.type)));
  if (request.swimmer) return {Vec3::Constant(-reach), Vec3::Constant(reach)};
  const Region fluid = fluid_of(layout.domain);
  if (layout.domain.box) return fluid;
  Region region;
  for (const PlacedBead& bead : placed_beads(layout)) region.extend(bead.centre);
  return Region(region.min().array() - reach, region.max().array() + reach).intersection(fluid);
}

/// Throws InputError if places lie outside the fluid. Those in the frame of a swimmer move with it.
void require_in_fluid(const Region& places, const FlowRequest& request, const Layout& layout,
                      Setting setting) {
  const Region fluid = fluid_of(layout.domain);
  if (request.swimmer || fluid.contains(places)) return;
  for (int a = 0; a < 3; ++a) {
    if (places.min()[a] >= fluid.min()[a] && places.max()[a] <= fluid.max()[a]) continue;
    throw InputError(
        setting,
        "the places from {:.6g} to {:.6g} along {} go beyond the fluid, which is there from {:.6g} "
        "to {:.6g}; give places in it",
        places.min()[a], places.max()[a], "xyz"[a], fluid.min()[a], fluid.max()[a]);
  }
}

/// Returns cells with their centres in the region: as many as fit along each axis, and at least one.
VtiCells cells_in(const Region& region, double spacing) {
  constexpr double roundoff = 1e-9;
  const auto fitting = [&](double edge) -> Vec3 {
    return (region.sizes() / edge * (1 + roundoff)).array().floor().max(1);
  };
  if (const double cells = fitting(spacing).prod(); cells > max_places) {
    double possible = spacing;
    while (fitting(possible).prod() > max_places) possible *= 1.05;
    throw InputError(
        Setting::flow_spacing,
        "a region of {:.6g} x {:.6g} x {:.6g} has {:.3g} cells of {:.6g}, more than {:.0e}; give at "
        "least {:.3g}, or a smaller {}",
        region.sizes()[0], region.sizes()[1], region.sizes()[2], cells, spacing, max_places, possible,
        Setting::flow_region);
  }
  const Vec3 cells = fitting(spacing);
  return {.cells = cells.cast<int>().array(),
          .spacing = spacing,
          .origin = region.center() - 0.5 * spacing * cells};
}

std::vector<Vec3> centres_of(const VtiCells& cells) {
  std::vector<Vec3> centres;
  centres.reserve(cells.cells.cast<std::size_t>().prod());
  for (int z = 0; z < cells.cells[2]; ++z)
    for (int y = 0; y < cells.cells[1]; ++y)
      for (int x = 0; x < cells.cells[0]; ++x)
        centres.push_back(cells.origin + cells.spacing * (Vec3(x, y, z).array() + 0.5).matrix());
  return centres;
}

std::vector<Vec3> read_points(const std::string& path) {
  const std::string text = read_text(path);
  std::vector<Vec3> points;
  std::array<std::size_t, 3> column{};
  std::size_t line_number = 0;
  for (std::string& line : split_at('\n', text)) {
    ++line_number;
    if (line.ends_with('\r')) line.pop_back();
    const auto values = split_at(',', line);
    if (line_number == 1) {
      for (int a = 0; a < 3; ++a) {
        const auto name = std::ranges::find(values, std::string_view("xyz").substr(a, 1));
        if (name == values.end())
          throw InputError(path, "line 1 names no column {}; begin with the line x,y,z", "xyz"[a]);
        column[a] = name - values.begin();
      }
      continue;
    }
    if (line.empty()) continue;
    Vec3& point = points.emplace_back();
    for (int a = 0; a < 3; ++a) {
      const auto number = column[a] < values.size() ? number_in(values[column[a]]) : std::nullopt;
      if (!number)
        throw InputError(path, "line {} has no finite number in the column {}; give one", line_number,
                         "xyz"[a]);
      point[a] = *number;
    }
  }
  if (points.empty()) throw InputError(path, "the file has no points; give a line with x, y, z for each");
  if (static_cast<double>(points.size()) > max_places)
    throw InputError(path, "the file has more than {:.0e} points; give fewer", max_places);
  return points;
}

/// Frame of the flow: the box, or a swimmer, which has no id in layouts with one.
struct FrameName {
  bool is_swimmer = false;
  std::optional<double> id{};
};

FrameName parse_frame(const std::string& frame) {
  const auto parts = split_at(':', frame);
  FrameName name{.is_swimmer = parts[0] == "swimmer"};
  if (parts.size() == 2) name.id = number_in(parts[1]);
  const bool is_whole = name.is_swimmer && (parts.size() == 1 || (parts.size() == 2 && name.id));
  if (frame != "box" && !is_whole)
    throw InputError(Setting::flow_frame, "\"{}\" is no frame; give box, swimmer or swimmer:ID", frame);
  return name;
}

/// Returns the id of the swimmer in whose frame the flow is; nullopt: the box.
std::optional<int> swimmer_of_frame(const std::string& frame, const Layout& layout) {
  const FrameName name = parse_frame(frame);
  if (!name.is_swimmer) return std::nullopt;
  if (!name.id && layout.swimmers.size() == 1) return layout.swimmers[0].id;
  for (const Swimmer& swimmer : layout.swimmers)
    if (name.id && swimmer.id == *name.id) return swimmer.id;
  throw InputError(Setting::flow_frame,
                   "\"{}\" is no frame of this layout; give box{} or swimmer:ID with the id of a swimmer",
                   frame, layout.swimmers.size() == 1 ? ", swimmer" : "");
}

}  // namespace

void require_flow_syntax(const RunSettings& settings) {
  parse_frame(settings.flow_frame);
  if (!settings.flow_region.empty()) parse_region(settings.flow_region);
}

std::optional<FlowRequest> flow_request(const RunSettings& settings, const Layout& layout, double spacing) {
  const bool has_time = settings.flow_every || settings.flow_mean;
  const bool has_points = !settings.flow_points.empty(),
             has_cells = settings.flow_spacing || !settings.flow_region.empty(),
             has_frame = settings.flow_frame != "box";
  if (!has_time) {
    for (const auto& [is_given, setting] :
         {std::pair(has_points, Setting::flow_points),
          std::pair(!settings.flow_region.empty(), Setting::flow_region),
          std::pair(settings.flow_spacing.has_value(), Setting::flow_spacing),
          std::pair(has_frame, Setting::flow_frame)})
      if (is_given)
        throw InputError(setting, "no flow is asked for; add {} or {}, or leave this out",
                         Setting::flow_every, Setting::flow_mean);
    return std::nullopt;
  }
  if (settings.flow_every && settings.flow_mean)
    throw InputError(Setting::flow_mean, "a run writes the present flow or a mean flow; leave out {} or {}",
                     Setting::flow_every, Setting::flow_mean);
  if (settings.flow_mean && *settings.flow_mean > settings.cycles * (1 + 1e-9))
    throw InputError(Setting::flow_mean,
                     "the run has {} cycles, fewer than the {} of the mean; give at most {}", settings.cycles,
                     *settings.flow_mean, std::floor(settings.cycles));
  if (has_points && has_cells)
    throw InputError(Setting::flow_points, "points and a grid exclude each other; leave out {}, or {} and {}",
                     Setting::flow_points, Setting::flow_region, Setting::flow_spacing);
  FlowRequest request{.mean_cycles = settings.flow_mean,
                      .swimmer = swimmer_of_frame(settings.flow_frame, layout)};
  request.is_grid = !has_points;
  request.is_on_lattice =
      settings.model == RunModel::lbm && settings.flow_every && !has_points && !has_cells && !request.swimmer;
  if (request.is_on_lattice) return request;
  if (has_points) {
    request.points = read_points(settings.flow_points);
    Region places;
    for (const Vec3& point : request.points) places.extend(point);
    require_in_fluid(places, request, layout, Setting::flow_points);
    return request;
  }
  const Region region =
      settings.flow_region.empty() ? usual_region(request, layout) : parse_region(settings.flow_region);
  require_in_fluid(region, request, layout, Setting::flow_region);
  request.cells = cells_in(region, settings.flow_spacing.value_or(spacing));
  request.cells.mean_cycles = request.mean_cycles;
  request.cells.frame_swimmer = request.swimmer;
  request.points = centres_of(request.cells);
  return request;
}

}  // namespace beadswim
