#include "flow_arrows.hpp"

#include "beadswim/core/error.hpp"
#include "beadswim/io/vti.hpp"

namespace beadswim {
namespace {

constexpr int max_arrows = 4000;       // more would hide one another
constexpr float covered_share = 0.5F;  // share of time within beads from which a cell has no arrow

void require_frame_of_box(const std::string& path, const VtiCells& cells) {
  if (!cells.frame_swimmer) return;
  throw InputError(
      path,
      "the flow is in the frame of swimmer {}, but the page shows the box; give a flow file of a "
      "run without --flow-frame",
      *cells.frame_swimmer);
}

/// Throws InputError if the gap between the flow and the scene (the box, or the beads of the first frame) is
/// more than ten times as wide as both together.
void require_near(const std::string& path, const VtiCells& cells, const TrajectoryFile& run) {
  const Eigen::AlignedBox3d flow = cells.extent();
  Eigen::AlignedBox3d scene;
  for (const Vec3& position : run.reader.frame(0).positions) scene.extend(position);
  if (const auto& box = run.layout.domain.box) scene = {Vec3::Zero(), box->lengths};
  if (flow.exteriorDistance(scene) <= 10 * (flow.diagonal().norm() + scene.diagonal().norm())) return;
  const Vec3 there = flow.center(), here = scene.center();
  throw InputError(
      path,
      "the flow around ({:.6g}, {:.6g}, {:.6g}) is far from the swimmers around ({:.6g}, {:.6g}, "
      "{:.6g}); give a flow file of the same run",
      there[0], there[1], there[2], here[0], here[1], here[2]);
}

/// Returns the smallest distance [cells] between arrows with which there are at most max_arrows.
int arrow_distance(const Index3& cells) {
  int distance = 1;
  while (((cells.cast<double>() - 1) / distance + 1).floor().prod() > max_arrows) ++distance;
  return distance;
}

}  // namespace

FlowArrows read_flow_arrows(const std::string& path, const TrajectoryFile& run) {
  const VtiReader file(path);
  const VtiCells& grid = file.cells();
  require_frame_of_box(path, grid);
  require_near(path, grid, run);
  const int distance = arrow_distance(grid.cells);
  const Index3 first = (grid.cells - 1).unaryExpr([&](int last) { return last % distance / 2; });  // centred
  FlowArrows arrows{.spacing = distance * grid.spacing, .mean_cycles = grid.mean_cycles};
  for (int z = first[2]; z < grid.cells[2]; z += distance) {
    const std::vector<float> velocity = file.plane("velocity", 3, z), bead = file.plane("bead", 1, z);
    std::vector<float> hidden(bead.size(), 0);
    if (file.has(vti_hiding_field)) hidden = file.plane(vti_hiding_field, 1, z);
    for (int y = first[1]; y < grid.cells[1]; y += distance)
      for (int x = first[0]; x < grid.cells[0]; x += distance) {
        const std::size_t cell = static_cast<std::size_t>(y) * grid.cells[0] + x;
        if (bead[cell] >= covered_share || hidden[cell] != 0) continue;
        arrows.places.emplace_back(grid.origin + grid.spacing * Vec3(x + 0.5, y + 0.5, z + 0.5));
        const float* u = &velocity[3 * cell];
        arrows.velocities.emplace_back(u[0], u[1], u[2]);
      }
  }
  if (arrows.places.empty())
    throw InputError(path, "all cells of the flow lie in beads or are hidden; give a flow file with fluid");
  return arrows;
}

}  // namespace beadswim
