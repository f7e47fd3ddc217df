#include "flow_field.hpp"

#include <algorithm>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

bool contains(const VtiReader& file, const FlowPlane& plane) {
  const Eigen::AlignedBox3d extent = file.cells().extent();
  return *plane.coordinate >= extent.min()[*plane.across] && *plane.coordinate <= extent.max()[*plane.across];
}

/// Returns the flow in a plane that the cells of the file contain.
FlowLayer layer_of(const VtiReader& file, int across, double coordinate) {
  const VtiCells& grid = file.cells();
  const Index3 cells = grid.cells;
  const int right = across == 0 ? 1 : 0, up = across == 2 ? 1 : 2, last = cells[across] - 1;
  const double place =
      std::clamp((coordinate - grid.origin[across]) / grid.spacing - 0.5, 0.0, static_cast<double>(last));
  Index3 from = Index3::Zero(), end = cells;
  from[across] = std::min(static_cast<int>(place), last);
  end[across] = std::min(from[across] + 1, last) + 1;
  const double upper_weight = place - from[across];

  FlowLayer layer{.origin = {grid.origin[right], grid.origin[up]},
                  .spacing = grid.spacing,
                  .cells = {cells[right], cells[up]},
                  .velocity = {}};
  layer.velocity.assign(layer.cells.prod(), Vec3::Zero());
  layer.covered.assign(layer.cells.prod(), 0);
  std::vector<double> weights(layer.cells.prod(), 0);
  const bool has_hidden = file.has(vti_hiding_field);
  for (int z = from[2]; z < end[2]; ++z) {
    const std::vector<float> velocity = file.plane("velocity", 3, z), bead = file.plane("bead", 1, z),
                             hidden = has_hidden ? file.plane(vti_hiding_field, 1, z) : std::vector<float>{};
    for (int y = from[1]; y < end[1]; ++y)
      for (int x = from[0]; x < end[0]; ++x) {
        const Index3 cell(x, y, z);
        const std::size_t in_file = static_cast<std::size_t>(y) * cells[0] + x;
        const std::size_t n = layer.index(cell[right], cell[up]);
        const double weight = cell[across] == from[across] ? 1 - upper_weight : upper_weight;
        if (has_hidden && hidden[in_file] != 0) continue;
        const float* u = &velocity[3 * in_file];
        weights[n] += weight;
        layer.velocity[n] += weight * Vec3(u[0], u[1], u[2]);
        layer.covered[n] += weight * std::clamp(bead[in_file], 0.0F, 1.0F);
      }
  }
  for (std::size_t n = 0; n < weights.size(); ++n) {
    if (has_hidden) layer.hidden.push_back(weights[n] == 0);
    if (weights[n] == 0) continue;
    layer.velocity[n] /= weights[n];
    layer.covered[n] /= weights[n];
  }
  return layer;
}

}  // namespace

FlowField::FlowField(const std::vector<std::string>& paths) : source_(paths.front()) {
  for (const std::string& path : paths) extent_.extend(files_.emplace_back(path).cells().extent());
}

FlowPlane FlowField::resolved(const FlowPlane& wanted) const {
  const Index3 cells = files_.front().cells().cells;
  const std::array<const char*, 3> planes{"yz", "xz", "xy"};
  int thin = 2;  // axis with one layer of cells
  while (thin >= 0 && cells[thin] > 1) --thin;
  FlowPlane plane = wanted;
  if (!plane.across) plane.across = thin >= 0 ? thin : 2;
  const int axis = *plane.across;
  if (thin >= 0 && cells[axis] > 1)
    throw InputError(
        "--plane",
        "the flow in {} has only one layer of cells along {}, so the plane {} is only a line; give {}",
        source_, "xyz"[thin], planes[axis], planes[thin]);
  const double low = extent_.min()[axis], high = extent_.max()[axis];
  if (!plane.coordinate) plane.coordinate = (low + high) / 2;
  const auto has_plane = [&](const VtiReader& file) { return contains(file, plane); };
  if (std::ranges::any_of(files_, has_plane)) return plane;
  throw InputError("--plane",
                   "the flow in {} has no {} = {:g}, only {:g} to {:g}; give a coordinate in this range",
                   source_, "xyz"[axis], *plane.coordinate, low, high);
}

std::vector<FlowLayer> FlowField::layers(const FlowPlane& plane) const {
  std::vector<FlowLayer> layers;
  for (const VtiReader& file : files_)
    if (contains(file, plane)) layers.push_back(layer_of(file, *plane.across, *plane.coordinate));
  return layers;
}

}  // namespace beadswim
