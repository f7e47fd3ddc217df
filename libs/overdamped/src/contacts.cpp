#include "beadswim/overdamped/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"

namespace beadswim {
namespace {

class ContactFinder {
 public:
  ContactFinder(const ContactScale& scale, std::vector<Contact>& contacts)
      : scale_(scale), contacts_(contacts) {}

  /// Adds a pair of beads as a contact if the gap of their surfaces is below the cutoff. `separation` is the
  /// vector from the centre of the second bead to the centre of the first, `radii` the sum of their radii
  /// [length]. `is_image`: the second bead is a periodic image.
  void add_pair(int first, int second, bool is_image, const Vec3& separation, double radii) {
    const double distance = separation.norm(), gap = distance - radii;
    const bool is_own = !is_image && scale_.swimmer[first] == scale_.swimmer[second];
    const double per_radius = is_own ? scale_.own_cutoff_per_radius[first] : scale_.cutoff_per_radius;
    const Vec3 normal = distance > 0 ? Vec3(separation / distance) : Vec3::UnitX();
    add(first, second, is_image, normal, gap, per_radius * radii / 2);
  }

  /// Adds a bead and its mirror image as a contact if their gap is below the cutoff. `to_wall` is the
  /// distance of the centre from the wall, negative if the centre is beyond the wall. `inward` is the unit
  /// normal of the wall into the box.
  void add_wall(int bead, double to_wall, const Vec3& inward, double radius) {
    add(bead, bead, true, inward, 2 * (to_wall - radius), scale_.cutoff_per_radius * radius);
  }

 private:
  void add(int first, int second, bool is_image, const Vec3& normal, double gap, double cutoff) {
    if (gap >= cutoff) return;
    contacts_.push_back({.first = first,
                         .second = second,
                         .is_image = is_image,
                         .normal = normal,
                         .gap = gap,
                         .cutoff = cutoff,
                         .law = contact_force(gap, cutoff, scale_.strength)});
  }

  const ContactScale& scale_;
  std::vector<Contact>& contacts_;
};

/// Returns the smallest gap between two beads of a swimmer at rest, divided by their mean radius.
double smallest_gap_at_rest(const SwimmerType& type) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < type.beads.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double radii = type.beads[i].radius + type.beads[j].radius;
      smallest = std::min(smallest, 2 * (type.beads[i].at - type.beads[j].at).norm() / radii - 2);
    }
  }
  return smallest;
}

}  // namespace

ContactScale::ContactScale(const OverdampedScene& scene)
    : largest_radius(beadswim::largest_radius(scene.types)) {
  double spring = 0;
  for (const SwimmerType& type : scene.types) {
    strength = std::max(strength, largest_driving_force(type));
    for (const Bond& bond : type.bonds) spring = std::max(spring, bond.stiffness);
  }
  if (strength == 0) strength = spring * largest_radius;
  std::vector<double> cutoff_of_type;
  for (const SwimmerType& type : scene.types)
    cutoff_of_type.push_back(std::min(cutoff_per_radius, smallest_gap_at_rest(type) / 2));
  min_cutoff_per_radius = std::ranges::min(cutoff_of_type);
  for (std::size_t s = 0; s < scene.swimmers.size(); ++s) {
    const std::size_t beads = scene.type_of(scene.swimmers[s]).beads.size();
    own_cutoff_per_radius.insert(own_cutoff_per_radius.end(), beads, cutoff_of_type[scene.swimmers[s].type]);
    swimmer.insert(swimmer.end(), beads, static_cast<int>(s));
  }
}

std::vector<Contact> find_contacts(const ContactScale& scale, const Domain& domain,
                                   std::span<const double> radii, std::span<const Vec3> positions) {
  const std::optional<Box>& box = domain.box;
  std::vector<Contact> contacts;
  ContactFinder finder(scale, contacts);
  // The lengths are doubled along axes with walls, so that no pair is found across a wall.
  const Vec3 lengths = mirrored_lengths(box);
  const CellList cells(positions, (2 + scale.cutoff_per_radius) * scale.largest_radius, lengths);
  const std::vector<int>& order = cells.order();
  for (int s = 0; s < std::ssize(order); ++s) {
    const int i = order[s];
    cells.for_each_range_after(s, [&](int begin, int end) {
      for (int t = begin; t < end; ++t) {
        const Vec3 direct = positions[i] - positions[order[t]];
        Vec3 d = direct;
        if (box)
          for (int a = 0; a < 3; ++a) d[a] -= lengths[a] * std::nearbyint(d[a] / lengths[a]);
        finder.add_pair(i, order[t], d != direct, d, radii[i] + radii[order[t]]);
      }
    });
    if (const auto& half_space = domain.half_space)
      finder.add_wall(i, half_space->height(positions[i]), Vec3::Unit(half_space->axis), radii[i]);
    if (!box) continue;
    for (int a = 0; a < 3; ++a) {
      if (!box->has_mirrors(a)) continue;
      const double to_far_wall = box->lengths[a] - positions[i][a];
      finder.add_wall(i, positions[i][a], Vec3::Unit(a), radii[i]);
      finder.add_wall(i, to_far_wall, -Vec3::Unit(a), radii[i]);
    }
  }
  return contacts;
}

}  // namespace beadswim
