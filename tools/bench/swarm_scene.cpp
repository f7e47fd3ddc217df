#include "swarm_scene.hpp"

#include <algorithm>
#include <numbers>
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

/// Parameters of the uniform swarm of the paper (Pickl et al. 2017) in lattice units.
constexpr double radius = 6, arm = 32, spacing = 32, length = 3 * arm;
constexpr double stiffness = 0.2, amplitude = 2, period = 2000, swarm_relaxation_time = 1.5;

/// Returns the swimmer of the paper's swarm with all lengths multiplied by `scale`.
SwimmerType make_swimmer_type(double scale) {
  ThreeBeadSwimmer type;
  type.beads.fill({.radius = radius * scale, .density = 1});
  type.springs.fill({.stiffness = stiffness, .rest_length = arm * scale, .damping = 0});
  type.angular_stiffness = 10 * stiffness * arm * arm;
  type.driving = {.amplitude = {amplitude * scale * scale, amplitude * scale * scale},
                  .phase = std::numbers::pi / 2,
                  .period = period,
                  .frame = DrivingFrame::lab};
  return swimmer_type(type);
}

}  // namespace

CoupledScene swarm_scene(int edge, int ranks, Precision precision, BeadScheme bead_boundary) {
  const double scale = std::min(1.0, edge / length);
  CoupledScene scene;
  scene.cells = {edge, edge, edge * ranks};
  scene.relaxation_time = swarm_relaxation_time;
  scene.precision = precision;
  scene.bead_boundary = bead_boundary;
  scene.types = {make_swimmer_type(scale)};
  const Index3 swimmers =
      (scene.cells.cast<double>() / (scale * Vec3(length, spacing, spacing).array()) + 1e-9)
          .floor()
          .cast<int>();
  const Vec3 distance = scene.cells.cast<double>() / swimmers.cast<double>();
  for (int z = 0; z < swimmers[2]; ++z) {
    for (int y = 0; y < swimmers[1]; ++y) {
      for (int x = 0; x < swimmers[0]; ++x) {
        const Vec3 middle = distance.array() * (Vec3(x, y, z).array() + 0.5);
        scene.swimmers.push_back(
            {.id = static_cast<int>(scene.swimmers.size()), .type = 0, .position = middle});
      }
    }
  }
  return scene;
}

}  // namespace beadswim
