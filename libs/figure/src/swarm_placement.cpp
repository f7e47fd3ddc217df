#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>

#include "beadswim/figure/swarm_picture.hpp"

namespace beadswim {
namespace {

/// Place of the distance arrows along one axis. The arrows are drawn at the swimmers that are furthest in the
/// direction `direction`. These swimmers are at the outline of the picture. The arrows are displaced from the
/// beads in the direction `arrow_offset`.
struct Outline {
  Vec3 direction, arrow_offset;
};

const std::array<Outline, 3> outlines{Outline{{0, -1, -1}, {0, 0, -1}}, Outline{{1, 0, -1}, {0, 0, -1}},
                                      Outline{{1, 1, 0}, {1, 0, 0}}};

constexpr double offset_radii = 3;  // distance of the arrows from the bead centres, divided by the radius

const PicturedBead& furthest_along_x(const PicturedSwimmer& swimmer, double sign) {
  const auto along = [sign](const PicturedBead& bead) { return sign * bead.centre.x(); };
  return *std::ranges::max_element(swimmer.beads, {}, along);
}

/// Returns the distance from one swimmer to the next along an axis.
PictureDistance distance_between(const PicturedSwimmer& one, const PicturedSwimmer& next, int axis,
                                 char kind) {
  const PicturedBead& from = furthest_along_x(one, 1);
  const PicturedBead& to = furthest_along_x(next, axis == 0 ? -1 : 1);
  const double length = to.centre[axis] - from.centre[axis];
  return {.label = fmt::format("{}_{} = {:.4g}", kind, "xyz"[axis], length),
          .from = from.centre,
          .to = from.centre + length * Vec3::Unit(axis),
          .arrow_offset = offset_radii * from.radius * outlines[axis].arrow_offset};
}

}  // namespace

void wrap_swimmers(std::vector<PicturedSwimmer>& swimmers, const Box& box) {
  for (PicturedSwimmer& swimmer : swimmers) {
    const Vec3 shift = box.lengths.cwiseProduct(image_number(swimmer.middle_bead().centre, box));
    for (PicturedBead& bead : swimmer.beads) bead.centre -= shift;
  }
}

Vec3 enclose_swimmers(std::vector<PicturedSwimmer>& swimmers) {
  Eigen::AlignedBox3d box;
  for (const PicturedSwimmer& swimmer : swimmers)
    for (const PicturedBead& bead : swimmer.beads)
      for (const double margin : {-2 * bead.radius, 2 * bead.radius})
        box.extend(bead.centre + Vec3::Constant(margin));
  for (PicturedSwimmer& swimmer : swimmers)
    for (PicturedBead& bead : swimmer.beads) bead.centre -= box.min();
  return box.sizes();
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
      const double far = outlines[axis].direction.dot(swimmer->middle_bead().centre);
      const auto best = furthest.find(kind);
      if (best != furthest.end() && best->second.first >= far) continue;
      furthest[kind] = {far, distance_between(*swimmer, *neighbour->second, axis, kind)};
    }
    for (const auto& [kind, found] : furthest) distances.push_back(found.second);
  }
  return distances;
}

}  // namespace beadswim
