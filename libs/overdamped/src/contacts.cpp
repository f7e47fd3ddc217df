#include "contacts.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/mobility/neighbour_cells.hpp"

namespace beadswim {
namespace {

/// Of the periodic box; across walls twice as long, so that nothing is nearer through them.
std::array<double, 3> periods(const std::optional<Box>& box) {
  std::array<double, 3> lengths{};
  if (box)
    for (int a = 0; a < 3; ++a) lengths[a] = box->lengths[a] * (box->free_slip[a] ? 2 : 1);
  return lengths;
}

class Finder {
 public:
  Finder(const ContactScale& scale, Contacts& contacts) : scale_(scale), contacts_(contacts) {}

  void meet(int first, int second, const Vec3& separation, double radius_first, double radius_second) {
    const double distance = separation.norm(), gap = distance - radius_first - radius_second;
    const double reach = scale_.share * (radius_first + radius_second) / 2;
    if (gap >= reach || distance == 0) return;
    contacts_.smallest_gap = std::min(contacts_.smallest_gap, gap);
    contacts_.list.push_back(
        {first, second, separation / distance, contact_force(gap, reach, scale_.strength)});
  }

 private:
  const ContactScale& scale_;
  Contacts& contacts_;
};

}  // namespace

ContactScale::ContactScale(const OverdampedScene& scene) {
  double spring = 0;
  for (const SwimmerType& type : scene.types) {
    strength = std::max(strength, type.driving.amplitude[0] + type.driving.amplitude[1]);
    for (const Bead& bead : type.beads) largest_radius = std::max(largest_radius, bead.radius);
    spring = std::max({spring, type.springs[0].stiffness, type.springs[1].stiffness});
  }
  if (strength == 0) strength = spring * largest_radius;
}

Contacts find_contacts(const ContactScale& scale, const std::optional<Box>& box,
                       std::span<const double> radii, std::span<const Vec3> positions) {
  Contacts contacts;
  Finder finder(scale, contacts);
  const std::array<double, 3> lengths = periods(box);
  const NeighbourCells cells(positions, (2 + scale.share) * scale.largest_radius, lengths);
  const std::vector<int>& order = cells.order();
  for (int s = 0; s < std::ssize(order); ++s) {
    const int i = order[s];
    cells.for_each_stretch_after(s, [&](int begin, int end) {
      for (int t = begin; t < end; ++t) {
        Vec3 d = positions[i] - positions[order[t]];
        if (box)
          for (int a = 0; a < 3; ++a) d[a] -= lengths[a] * std::nearbyint(d[a] / lengths[a]);
        finder.meet(i, order[t], d, radii[i], radii[order[t]]);
      }
    });
    if (!box) continue;
    for (int a = 0; a < 3; ++a) {
      if (!box->free_slip[a]) continue;
      const double to_far_wall = box->lengths[a] - positions[i][a];
      const double image = positions[i][a] < to_far_wall ? 2 * positions[i][a] : -2 * to_far_wall;
      finder.meet(i, i, image * Vec3::Unit(a), radii[i], radii[i]);
    }
  }
  return contacts;
}

}  // namespace beadswim
