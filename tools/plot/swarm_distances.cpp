#include "swarm_distances.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

/// Where the distances along an axis are drawn: at the swimmers furthest in this direction, which is the
/// outline of the picture, and moved aside from there.
struct Outline {
  Vec3 towards, aside;
};

const std::array<Outline, 3> outlines{Outline{{0, -1, -1}, {0, 0, -1}}, Outline{{1, 0, -1}, {0, 0, -1}},
                                      Outline{{1, 1, 0}, {1, 0, 0}}};

constexpr double aside_radii = 3;

std::size_t furthest_along_x(const PicturedSwimmer& swimmer, double sign) {
  const auto along = [sign](const Vec3& bead) { return sign * bead.x(); };
  return static_cast<std::size_t>(std::ranges::max_element(swimmer.beads, {}, along) - swimmer.beads.begin());
}

/// From one swimmer to the next along an axis.
PictureDistance distance_between(const PicturedSwimmer& one, const PicturedSwimmer& next, int axis,
                                 char kind) {
  const std::size_t from = furthest_along_x(one, 1), to = furthest_along_x(next, axis == 0 ? -1 : 1);
  const double length = next.beads[to][axis] - one.beads[from][axis];
  return {.label = fmt::format("{}_{} = {:.4g}", kind, "xyz"[axis], length),
          .from = one.beads[from],
          .to = one.beads[from] + length * Vec3::Unit(axis),
          .aside = aside_radii * one.radii[from] * outlines[axis].aside};
}

}  // namespace

std::vector<PictureDistance> swarm_distances(std::span<const PicturedSwimmer> swimmers,
                                             std::span<const Layer> layers,
                                             std::span<const int> block_swimmers) {
  if (block_swimmers.size() != 3) {
    throw InputError("--distances", "blocks by id have no axes; give --block-swimmers as NX,NY,NZ");
  }
  std::map<Layer, const PicturedSwimmer*> at;
  for (std::size_t s = 0; s < swimmers.size(); ++s) at.emplace(layers[s], &swimmers[s]);
  std::vector<PictureDistance> distances;
  for (int axis = 0; axis < 3; ++axis) {
    std::map<char, std::pair<double, PictureDistance>> furthest;  // by C and D
    for (const auto& [layer, swimmer] : at) {
      Layer next = layer;
      ++next[axis];
      const auto neighbour = at.find(next);
      if (neighbour == at.end()) continue;
      const char kind = layer[axis] / block_swimmers[axis] == next[axis] / block_swimmers[axis] ? 'C' : 'D';
      const double far = outlines[axis].towards.dot(swimmer->beads[1]);
      const auto best = furthest.find(kind);
      if (best != furthest.end() && best->second.first >= far) continue;
      furthest[kind] = {far, distance_between(*swimmer, *neighbour->second, axis, kind)};
    }
    for (const auto& [kind, found] : furthest) distances.push_back(found.second);
  }
  if (distances.empty()) {
    throw InputError("--distances",
                     "no swimmer has a neighbour along an axis; draw periodic copies too, "
                     "as with --repeat 2,2,2");
  }
  return distances;
}

}  // namespace beadswim
