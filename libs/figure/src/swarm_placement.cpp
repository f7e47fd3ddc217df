#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "beadswim/figure/swarm_picture.hpp"

namespace beadswim {
namespace {

/// Determines the positions of the distances along one axis. Distances are drawn at the swimmers that are
/// furthest in the direction `direction`, which are at the outline of the picture. Their arrows are displaced
/// in the direction `arrow_offset`.
struct Outline {
  Vec3 direction, arrow_offset;
};

const std::array<Outline, 3> outlines{Outline{{0, -1, -1}, {0, 0, -1}}, Outline{{1, 0, -1}, {0, 0, -1}},
                                      Outline{{1, 1, 0}, {1, 0, 0}}};

constexpr double offset_radii = 3;  // distance of the arrows from the bead centres, in radii

std::size_t furthest_along_x(const PicturedSwimmer& swimmer, double sign) {
  const auto along = [sign](const Vec3& bead) { return sign * bead.x(); };
  return static_cast<std::size_t>(std::ranges::max_element(swimmer.beads, {}, along) - swimmer.beads.begin());
}

/// Returns the distance from one swimmer to the next along an axis.
PictureDistance distance_between(const PicturedSwimmer& one, const PicturedSwimmer& next, int axis,
                                 char kind) {
  const std::size_t from = furthest_along_x(one, 1), to = furthest_along_x(next, axis == 0 ? -1 : 1);
  const double length = next.beads[to][axis] - one.beads[from][axis];
  return {.label = fmt::format("{}_{} = {:.4g}", kind, "xyz"[axis], length),
          .from = one.beads[from],
          .to = one.beads[from] + length * Vec3::Unit(axis),
          .arrow_offset = offset_radii * one.radii[from] * outlines[axis].arrow_offset};
}

}  // namespace

void wrap_swimmers(std::vector<PicturedSwimmer>& swimmers, const Box& box) {
  for (PicturedSwimmer& swimmer : swimmers) {
    const Vec3 shift = box.lengths.cwiseProduct(image_number(swimmer.beads[1], box));
    for (Vec3& bead : swimmer.beads) bead -= shift;
  }
}

Vec3 enclose_swimmers(std::vector<PicturedSwimmer>& swimmers) {
  Vec3 low = Vec3::Constant(INFINITY), high = -low;
  for (const PicturedSwimmer& swimmer : swimmers) {
    for (std::size_t b = 0; b < 3; ++b) {
      low = low.cwiseMin((swimmer.beads[b].array() - 2 * swimmer.radii[b]).matrix());
      high = high.cwiseMax((swimmer.beads[b].array() + 2 * swimmer.radii[b]).matrix());
    }
  }
  for (PicturedSwimmer& swimmer : swimmers) {
    for (Vec3& bead : swimmer.beads) bead -= low;
  }
  return high - low;
}

std::vector<PictureDistance> swarm_distances(const std::vector<PicturedSwimmer>& swimmers,
                                             const std::vector<int>& block_swimmers) {
  std::map<std::array<int, 3>, const PicturedSwimmer*> at;
  for (const PicturedSwimmer& swimmer : swimmers) at.emplace(swimmer.layer, &swimmer);
  std::vector<PictureDistance> distances;
  for (int axis = 0; axis < 3; ++axis) {
    const int in_block = block_swimmers[static_cast<std::size_t>(axis)];
    std::map<char, std::pair<double, PictureDistance>> furthest;  // keys: 'C' and 'D'
    for (const auto& [layer, swimmer] : at) {
      std::array<int, 3> next = layer;
      ++next[axis];
      const auto neighbour = at.find(next);
      if (neighbour == at.end()) continue;
      const char kind = layer[axis] / in_block == next[axis] / in_block ? 'C' : 'D';
      const double far = outlines[axis].direction.dot(swimmer->beads[1]);
      const auto best = furthest.find(kind);
      if (best != furthest.end() && best->second.first >= far) continue;
      furthest[kind] = {far, distance_between(*swimmer, *neighbour->second, axis, kind)};
    }
    for (const auto& [kind, found] : furthest) distances.push_back(found.second);
  }
  return distances;
}

}  // namespace beadswim
