#include "beadswim/overdamped/contacts.hpp"

#include <algorithm>
#include <limits>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/scene/layout.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"

namespace beadswim {
namespace {

/// Returns the smallest gap between two beads of a swimmer at rest, divided by their mean radius.
double smallest_gap_at_rest(const SwimmerType& type) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::ssize(type.beads); ++i)
    for (int j = 0; j < i; ++j)
      smallest = std::min(smallest, 2 * distance_at_rest(type, i, j) / contact_distance(type, i, j) - 2);
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
  constexpr double barrier = 20;  // the energy of touching beads is then some 35 kT
  double smallest = largest_radius;
  for (const SwimmerType& type : scene.types) smallest = std::min(smallest, smallest_radius(type));
  const double cutoff = min_cutoff_per_radius * smallest;
  if (scene.thermal_energy > 0) strength = std::max(strength, barrier * scene.thermal_energy / cutoff);
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
  const auto add = [&](int first, int second, bool is_own, const Vec3& normal, double gap, double cutoff) {
    if (gap >= cutoff) return;
    contacts.push_back({.first = first,
                        .second = second,
                        .is_own = is_own,
                        .normal = normal,
                        .gap = gap,
                        .cutoff = cutoff,
                        .law = contact_force(gap, cutoff, scale.strength)});
  };
  // `height`: distance of the centre of a bead from a wall, negative if the centre is beyond the wall.
  // `inward`: unit normal of the wall into the box.
  const auto add_mirror_image = [&](int bead, double height, const Vec3& inward) {
    add(bead, bead, false, inward, 2 * (height - radii[bead]), scale.cutoff_per_radius * radii[bead]);
  };
  const double cutoff = (2 + scale.cutoff_per_radius) * scale.largest_radius;
  visit_close_pairs(positions, cutoff, box, [&](int i, int j, const Vec3& d) {
    const bool is_own = d == positions[i] - positions[j] && scale.swimmer[i] == scale.swimmer[j];
    const double distance = d.norm(), touching = radii[i] + radii[j];
    const double per_radius = is_own ? scale.own_cutoff_per_radius[i] : scale.cutoff_per_radius;
    const Vec3 normal = distance > 0 ? Vec3(d / distance) : Vec3::UnitX();
    add(i, j, is_own, normal, distance - touching, per_radius * touching / 2);
    return true;
  });
  for (int i = 0; i < std::ssize(positions); ++i) {
    if (const auto& half_space = domain.half_space)
      add_mirror_image(i, half_space->height(positions[i]), Vec3::Unit(half_space->axis));
    for (int a = 0; a < 3 && box; ++a) {
      if (!box->has_mirrors(a)) continue;
      add_mirror_image(i, positions[i][a], Vec3::Unit(a));
      add_mirror_image(i, box->lengths[a] - positions[i][a], -Vec3::Unit(a));
    }
  }
  return contacts;
}

}  // namespace beadswim
