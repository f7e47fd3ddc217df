#include "beadswim/scene/placed_swimmers.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {

Swarm listed_swimmers(const Layout& layout) {
  Swarm swarm;
  std::map<std::string, int> shared_types;  // types of the swimmers without their own driving
  for (const Swimmer& swimmer : layout.swimmers) {
    int type = static_cast<int>(swarm.types.size());
    if (!swimmer.driving) type = shared_types.try_emplace(swimmer.type, type).first->second;
    if (type == std::ssize(swarm.types)) swarm.types.push_back(layout.resolved_type(swimmer));
    swarm.swimmers.push_back(
        {.id = swimmer.id, .type = type, .position = swimmer.position, .orientation = swimmer.orientation()});
    if (swimmer.start) swarm.swimmers.back().start = swimmer.start->positions;
  }
  return swarm;
}

Swarm placed_swimmers(const Layout& layout) {
  Swarm swarm = listed_swimmers(layout);
  std::ranges::sort(swarm.swimmers, {}, &PlacedSwimmer::id);
  return swarm;
}

std::vector<BeadRange> bead_ranges(const Swarm& swarm) {
  std::vector<BeadRange> ranges;
  std::size_t first = 0;
  for (const PlacedSwimmer& swimmer : swarm.swimmers) {
    const std::size_t last = first + swarm.type_of(swimmer).beads.size();
    ranges.push_back({first, last});
    first = last;
  }
  return ranges;
}

std::vector<Vec3> start_positions(const Swarm& swarm) {
  std::vector<SwimmerType> starts;
  for (const SwimmerType& type : swarm.types) starts.push_back(at_start(type));
  std::vector<Vec3> positions;
  for (const PlacedSwimmer& swimmer : swarm.swimmers) {
    const std::vector<Vec3> beads =
        swimmer.start.empty() ? rest_positions(starts[swimmer.type], swimmer.position, swimmer.orientation)
                              : swimmer.start;
    positions.insert(positions.end(), beads.begin(), beads.end());
  }
  return positions;
}

std::vector<double> bead_radii(const Swarm& swarm) {
  std::vector<double> radii;
  for (const PlacedSwimmer& swimmer : swarm.swimmers)
    for (const Bead& bead : swarm.type_of(swimmer).beads) radii.push_back(bead.radius);
  return radii;
}

double largest_radius(std::span<const SwimmerType> types) {
  double largest = 0;
  for (const SwimmerType& type : types)
    for (const Bead& bead : type.beads) largest = std::max(largest, bead.radius);
  return largest;
}

}  // namespace beadswim
