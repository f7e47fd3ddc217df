#include "beadswim/overdamped/contacts.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/core/cell_list.hpp"

namespace beadswim {
namespace {

class Finder {
 public:
  Finder(const ContactScale& scale, std::vector<Contact>& contacts) : scale_(scale), contacts_(contacts) {}

  /// `is_image`: of the second, on the other side of the box.
  void meet(int first, int second, bool is_image, const Vec3& separation, double radii) {
    const double distance = separation.norm(), gap = distance - radii;
    const double reach = scale_.share * radii / 2;
    if (gap >= reach) return;
    const Vec3 normal = distance > 0 ? Vec3(separation / distance) : Vec3::UnitX();
    contacts_.push_back(
        {first, second, is_image, normal, gap, reach, contact_force(gap, reach, scale_.strength)});
  }

  /// A bead and its image behind the wall that is `to_wall` away, below 0 beyond it; `inward`: from the wall.
  void meet_wall(int bead, double to_wall, const Vec3& inward, double radius) {
    const double gap = 2 * (to_wall - radius), reach = scale_.share * radius;
    if (gap >= reach) return;
    contacts_.push_back({bead, bead, true, inward, gap, reach, contact_force(gap, reach, scale_.strength)});
  }

 private:
  const ContactScale& scale_;
  std::vector<Contact>& contacts_;
};

}  // namespace

ContactScale::ContactScale(const OverdampedScene& scene)
    : largest_radius(beadswim::largest_radius(scene.types)) {
  double spring = 0;
  for (const SwimmerType& type : scene.types) {
    strength = std::max(strength, type.driving.amplitude[0] + type.driving.amplitude[1]);
    spring = std::max({spring, type.springs[0].stiffness, type.springs[1].stiffness});
  }
  if (strength == 0) strength = spring * largest_radius;
}

std::vector<Contact> find_contacts(const ContactScale& scale, const std::optional<Box>& box,
                                   std::span<const double> radii, std::span<const Vec3> positions) {
  std::vector<Contact> contacts;
  Finder finder(scale, contacts);
  const Vec3 lengths = mirrored_lengths(box);  // so that nothing is nearer through a wall
  const CellList cells(positions, (2 + scale.share) * scale.largest_radius, lengths);
  const std::vector<int>& order = cells.order();
  for (int s = 0; s < std::ssize(order); ++s) {
    const int i = order[s];
    cells.for_each_stretch_after(s, [&](int begin, int end) {
      for (int t = begin; t < end; ++t) {
        const Vec3 direct = positions[i] - positions[order[t]];
        Vec3 d = direct;
        if (box)
          for (int a = 0; a < 3; ++a) d[a] -= lengths[a] * std::nearbyint(d[a] / lengths[a]);
        finder.meet(i, order[t], d != direct, d, radii[i] + radii[order[t]]);
      }
    });
    if (!box) continue;
    for (int a = 0; a < 3; ++a) {
      if (!box->has_mirrors(a)) continue;
      const double to_far_wall = box->lengths[a] - positions[i][a];
      finder.meet_wall(i, positions[i][a], Vec3::Unit(a), radii[i]);
      finder.meet_wall(i, to_far_wall, -Vec3::Unit(a), radii[i]);
    }
  }
  return contacts;
}

}  // namespace beadswim
