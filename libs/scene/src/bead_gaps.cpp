#include "beadswim/scene/bead_gaps.hpp"

#include <algorithm>

#include "beadswim/scene/placed_swimmers.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

double surface_gap(const std::vector<PlacedBead>& beads, const BeadPair& pair) {
  return pair.distance - beads[pair.first].radius - beads[pair.second].radius;
}

std::vector<Vec3> centres_of(const std::vector<PlacedBead>& beads) {
  std::vector<Vec3> centres;
  for (const PlacedBead& bead : beads) centres.push_back(bead.centre);
  return centres;
}

/// Returns the largest distance of the centres of two beads whose surfaces are within `max_gap`.
double cutoff_for(const std::vector<PlacedBead>& beads, double max_gap) {
  double radius = 0;
  for (const PlacedBead& bead : beads) radius = std::max(radius, bead.radius);
  return 2 * radius + max_gap;
}

/// Returns the pairs of each bead with its own nearest image, one per periodic axis.
std::vector<BeadPair> own_image_pairs(const std::vector<PlacedBead>& beads,
                                      const std::optional<Box>& domain) {
  std::vector<BeadPair> pairs;
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain || !domain->is_periodic(axis)) continue;
    for (std::size_t i = 0; i < beads.size(); ++i)
      pairs.push_back({.first = i, .second = i, .distance = domain->lengths[axis]});
  }
  return pairs;
}

double smallest_wall_gap(const std::vector<PlacedBead>& beads, const Domain& domain) {
  double gap = std::numeric_limits<double>::infinity();
  for (const PlacedBead& bead : beads) {
    if (domain.half_space) gap = std::min(gap, domain.half_space->height(bead.centre) - bead.radius);
    for (int axis = 0; axis < 3 && domain.box; ++axis) {
      if (domain.box->is_periodic(axis)) continue;
      const double x = bead.centre[axis];
      gap = std::min({gap, x - bead.radius, domain.box->lengths[axis] - x - bead.radius});
    }
  }
  return gap;
}

}  // namespace

std::vector<PlacedBead> placed_beads(const Layout& layout) {
  std::vector<PlacedBead> beads;
  const Swarm swarm = listed_swimmers(layout);
  const std::vector<Vec3> centres = start_positions(swarm);
  for (std::size_t s = 0; s < swarm.swimmers.size(); ++s) {
    const std::vector<BeadAtRest>& of_type = swarm.type_of(swarm.swimmers[s]).beads;
    for (int i = 0; i < std::ssize(of_type); ++i)
      beads.push_back(
          {.centre = centres[beads.size()], .radius = of_type[i].radius, .swimmer = s, .bead = i});
  }
  return beads;
}

CellList bead_cells(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain, double max_gap) {
  return CellList(centres_of(beads), cutoff_for(beads, max_gap), domain ? domain->lengths : Vec3::Zero());
}

std::vector<BeadPair> close_pairs(const std::vector<PlacedBead>& beads, const std::optional<Box>& domain,
                                  double max_gap, std::size_t max_pairs) {
  std::vector<BeadPair> pairs;
  visit_close_pairs(centres_of(beads), cutoff_for(beads, max_gap), domain,
                    [&](std::size_t i, std::size_t j, const Vec3& d) {
                      const BeadPair pair{
                          .first = std::max(i, j), .second = std::min(i, j), .distance = d.norm()};
                      if (surface_gap(beads, pair) <= max_gap) pairs.push_back(pair);
                      return pairs.size() < max_pairs;
                    });
  std::ranges::sort(pairs, {}, [](const BeadPair& pair) { return std::pair(pair.first, pair.second); });
  return pairs;
}

std::vector<BeadPair> overlapping_pairs(const std::vector<PlacedBead>& beads,
                                        const std::optional<Box>& domain, std::size_t max_pairs) {
  std::vector<BeadPair> found = own_image_pairs(beads, domain);
  std::erase_if(found, [&](const BeadPair& pair) { return surface_gap(beads, pair) > 0; });
  std::ranges::move(close_pairs(beads, domain, 0, max_pairs), std::back_inserter(found));
  if (found.size() > max_pairs) found.resize(max_pairs);
  return found;
}

double smallest_gap(const std::vector<PlacedBead>& beads, const Domain& domain) {
  double gap = smallest_wall_gap(beads, domain);
  for (const BeadPair& pair : own_image_pairs(beads, domain.box))
    gap = std::min(gap, surface_gap(beads, pair));
  for (std::size_t i = 1; i < beads.size(); ++i) {  // gives an upper bound of the gap
    const BeadPair pair{
        .first = i, .second = i - 1, .distance = (beads[i].centre - beads[i - 1].centre).norm()};
    gap = std::min(gap, surface_gap(beads, pair));
  }
  for (const BeadPair& pair : close_pairs(beads, domain.box, gap))
    gap = std::min(gap, surface_gap(beads, pair));
  return gap;
}

double smallest_relative_height(const std::vector<PlacedBead>& beads, const HalfSpace& half_space) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const PlacedBead& bead : beads)
    smallest = std::min(smallest, half_space.height(bead.centre) / bead.radius);
  return smallest;
}

}  // namespace beadswim
