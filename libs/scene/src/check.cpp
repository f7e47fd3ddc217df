#include "beadswim/scene/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <unordered_map>
#include <unordered_set>

#include "beadswim/core/names.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/unit_scales.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/hinges.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

constexpr double axis_tolerance = 1e-6;
constexpr std::size_t max_overlaps = 1000;

class Faults : public std::vector<LayoutFault> {
 public:
  template <class... Values>
  void add(std::string place, fmt::format_string<Values...> message, Values&&... values) {
    push_back({std::move(place), fmt::format(message, std::forward<Values>(values)...)});
  }
};

std::string in_words(const Vec3& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]);
}

std::string swimmer_place(std::size_t index, const char* key) {
  return fmt::format("/swimmers/{}/{}", index, key);
}

void check_units(const Units& units, Faults& faults) {
  if (units.lattice) return;
  const auto check = [&](Quantity quantity, const Units::Unit& unit, const char* key) {
    const Units::Unit* known = find_known_unit(quantity, unit.name);
    constexpr double tolerance = 1e-9;
    if (!known || std::abs(unit.si_factor / known->si_factor - 1) < tolerance) return;
    faults.add(fmt::format("/units/{}/si_factor", key),
               "the factor {} is wrong: one {} is {} in SI units; give that factor or another unit name",
               unit.si_factor, unit.name, known->si_factor);
  };
  check(Quantity::length, units.length, "length");
  check(Quantity::time, units.time, "time");
  check(Quantity::mass, units.mass, "mass");
}

void check_graph(const std::string& place, const SwimmerType& type, Faults& faults) {
  const auto check_beads = [&](const std::string& key, const auto& beads) {
    for (std::size_t n = 0; n < beads.size(); ++n) {
      if (beads[n] >= std::ssize(type.beads))
        faults.add(fmt::format("{}/beads/{}", key, n),
                   "there is no bead {}; the type has {} beads, numbered from 1", beads[n] + 1,
                   type.beads.size());
      if (std::ranges::count(beads, beads[n]) > 1)
        faults.add(key + "/beads", "bead {} is named twice; name different beads", beads[n] + 1);
    }
  };
  std::map<std::pair<int, int>, std::size_t> bond_between;
  for (std::size_t k = 0; k < type.bonds.size(); ++k) {
    const auto& [first, second] = type.bonds[k].beads;
    const std::string key = fmt::format("{}/bonds/{}", place, k);
    check_beads(key, type.bonds[k].beads);
    const auto [entry, is_new] = bond_between.try_emplace(std::minmax({first, second}), k);
    if (!is_new)
      faults.add(key + "/beads", "beads {} and {} are already joined by bond {}; give each pair one bond",
                 first + 1, second + 1, entry->second + 1);
  }
  for (std::size_t k = 0; k < type.angles.size(); ++k)
    check_beads(fmt::format("{}/angles/{}", place, k), type.angles[k].beads);
}

/// Reports beads that no chain of bonds joins to bead 1.
void check_connections(const std::string& place, const SwimmerType& type, Faults& faults) {
  std::vector<bool> reached(type.beads.size());
  reached[0] = true;
  for (std::size_t round = 0; round < reached.size(); ++round) {
    for (const auto& bond : type.bonds) {
      const auto [i, j] = bond.beads;
      if (reached[i] || reached[j]) reached[i] = reached[j] = true;
    }
  }
  for (std::size_t b = 0; b < reached.size(); ++b) {
    if (reached[b]) continue;
    faults.add(fmt::format("{}/beads/{}", place, b),
               "no chain of bonds joins bead {} to bead 1; join the pieces, or make a type of each", b + 1);
    return;
  }
}

void check_beads_at_rest(const std::string& place, const SwimmerType& type, Faults& faults) {
  for (int i = 0; i < std::ssize(type.beads); ++i) {
    for (int j = i + 1; j < std::ssize(type.beads); ++j) {
      const double distance = distance_at_rest(type, i, j), contact = contact_distance(type, i, j);
      if (distance > contact) continue;
      faults.add(fmt::format("{}/beads/{}/at", place, j),
                 "beads {} and {} overlap at rest: their centres are {:.6g} apart, but must "
                 "be more than {} apart, the sum of their radii",
                 i + 1, j + 1, distance, contact);
    }
  }
}

void check_bond_lengths(const std::string& place, const SwimmerType& type, Faults& faults) {
  for (std::size_t k = 0; k < type.bonds.size(); ++k) {
    const auto [i, j] = type.bonds[k].beads;
    const double length = type.bonds[k].rest_length, contact = contact_distance(type, i, j);
    if (length > contact) continue;
    faults.add(fmt::format("{}/{}/rest_length", place, k),
               "with the rest length {}, beads {} and {} overlap; the rest length must "
               "be greater than {}, the sum of their radii",
               length, i + 1, j + 1, contact);
  }
  for (std::size_t k = 0; k < type.bonds.size(); ++k) {
    const auto [i, j] = type.bonds[k].beads;
    const double distance = distance_at_rest(type, i, j), length = type.bonds[k].rest_length;
    if (distance <= max_stretch * length) continue;
    faults.add(fmt::format("{}/{}/rest_length", place, k),
               "beads {} and {} are {:.6g} apart at rest, more than twice the rest length {}; "
               "give the bond a rest length near this distance",
               i + 1, j + 1, distance, length);
  }
}

/// Returns the sum of the amplitudes of the drives with one number, the largest change of what they drive.
double largest_change(const auto& drives, auto&& is_of) {
  double sum = 0;
  for (const auto& drive : drives) {
    if (is_of(drive)) sum += sum_of_amplitudes(drive.harmonics);
  }
  return sum;
}

/// Reports hinges that cannot bend about their normals.
void check_normals(const std::string& place, const SwimmerType& type, Faults& faults) {
  const BeadVectors at = columns_of_beads(rest_positions(type, Vec3::Zero(), Eigen::Matrix3d::Identity()));
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    const Angle& angle = type.angles[k];
    if (!angle.normal) continue;
    const std::string key = fmt::format("{}/angles/{}/normal", place, k);
    const auto& sides = sides_of(angle, at).direction;
    constexpr double upright = 1e-6;  // cosine
    if (std::abs(angle.normal->norm() - 1) > axis_tolerance ||
        std::abs(angle.normal->dot(sides[0])) > upright || std::abs(angle.normal->dot(sides[1])) > upright) {
      faults.add(key,
                 "the normal {} is not perpendicular to the sides of the angle at rest; give the axis about "
                 "which the beads turn, as [0, 0, 1] for beads in the plane z = 0",
                 in_words(*angle.normal));
    } else if (!separates_beads(type, angle)) {
      const auto [i, j, l] = angle.beads;
      faults.add(key,
                 "bonds join beads {} and {} also past bead {}, so that the angle is no hinge; remove the "
                 "normal or these bonds",
                 i + 1, l + 1, j + 1);
    }
  }
}

/// Reports a swimmer with hinges that do not determine its orientation at all times of the cycle.
void check_orientation_by_hinges(const std::string& place, const SwimmerType& type, Faults& faults) {
  if (!has_hinges(type)) return;
  const auto beads = [](const SwimmerType& shape) {
    return columns_of_beads(rest_positions(shape, Vec3::Zero(), Eigen::Matrix3d::Identity()));
  };
  constexpr int times = 1024;
  constexpr double thin = 0.02;
  double narrowest = std::numeric_limits<double>::infinity(), widest = 0;
  bool is_upright = true;
  for (int m = 0; m < times; ++m) {
    const BeadVectors shape = beads(at_rest_angles(type, type.driving.period * m / times));
    narrowest = std::min(narrowest, width_of(shape));
    widest = std::max(widest, width_of(shape));
    const Eigen::Matrix3d fit = fitted_orientation(type, shape, Eigen::Matrix3d::Identity());
    for (const Angle& angle : type.angles)
      is_upright = is_upright && (!angle.normal || angle.normal->dot(fit * *angle.normal) > 0);
  }
  constexpr double roundoff = 1e-6;
  const BeadVectors at = beads(type);
  const double straight = roundoff * at.colwise().norm().maxCoeff();
  if (widest > straight && narrowest < thin * widest) {
    faults.add(place + "/driving/angles",
               "all beads come in line in the cycle, where it is undetermined to which side the hinges bend; "
               "let them pass straight one after the other, or give the swimmer a bead beside the line");
  } else if (widest > straight && width_of(at) <= straight && !has_driven_shape(type.driving)) {
    faults.add(place + "/beads",
               "all beads are in line, where it is undetermined to which side the hinges bend; place the "
               "beads at the rest angles");
  } else if (!is_upright) {
    faults.add(
        place + "/beads",
        "the hinges bend the swimmer to the mirror image of its shape at rest, which is the same shape "
        "turned over; place the beads with straight hinges, all in line");
  }
}

/// Reports angular springs whose force has no direction, because the beads are in line at rest although the
/// rest angle is another or is driven, or whose rest angle leaves the range from 0 to pi, with a normal from
/// -pi to pi.
void check_angles(const std::string& place, const SwimmerType& type, Faults& faults) {
  constexpr double smallest_sine = 1e-6;
  for (std::size_t k = 0; k < type.angles.size(); ++k) {
    if (type.angles[k].normal) continue;
    if (type.angles[k].rest < 0)
      faults.add(fmt::format("{}/angles/{}/rest", place, k),
                 "the rest angle {:.6g} is negative, but the angle has no side; give it a \"normal\", or "
                 "the angle from 0 to pi",
                 type.angles[k].rest);
    const double theta = angle_at_rest(type, type.angles[k]);
    const auto drive = std::ranges::find(type.driving.angles, static_cast<int>(k), &AngleDrive::angle);
    const bool is_driven = drive != type.driving.angles.end();
    if (std::sin(theta) > smallest_sine || (!is_driven && type.angles[k].rest == theta)) continue;
    faults.add(is_driven ? fmt::format("{}/driving/angles/{}", place, drive - type.driving.angles.begin())
                         : fmt::format("{}/angles/{}/rest", place, k),
               "the three beads are in line at rest, so that the force of another rest angle has no "
               "direction; place the beads of this angle off a line, or give the angle a \"normal\"");
  }
  for (std::size_t n = 0; n < type.driving.angles.size(); ++n) {
    const int k = type.driving.angles[n].angle;
    const double rest = type.angles[k].rest;
    const double change =
        largest_change(type.driving.angles, [k](const AngleDrive& drive) { return drive.angle == k; });
    const bool has_normal = type.angles[k].normal.has_value();
    const double lowest = has_normal ? -std::numbers::pi : 0;
    if (rest - change > lowest && rest + change < std::numbers::pi) continue;
    faults.add(fmt::format("{}/driving/angles/{}", place, n),
               "the rest angle {:.6g} changes by up to {:.6g}, but must stay between {} and pi; "
               "lower the amplitudes{}",
               rest, change, has_normal ? "-pi" : "0",
               has_normal ? "" : ", or give the angle a \"normal\" to let it pass straight");
  }
  const std::size_t before = faults.size();
  check_normals(place, type, faults);
  if (faults.size() == before) check_orientation_by_hinges(place, type, faults);
}

/// Reports drives of beads, bonds and angles that do not exist, directions of length zero, and
/// forces that do not sum to zero.
void check_driving(const std::string& place, const SwimmerType& type, Faults& faults) {
  const Driving& driving = type.driving;
  const auto check_number = [&](const std::string& key, int number, std::size_t count, const char* what) {
    if (number < static_cast<int>(count)) return;
    faults.add(fmt::format("{}/{}", place, key), "there is no {} {}; the type has {} {}s, numbered from 1",
               what, number + 1, count, what);
  };
  for (std::size_t n = 0; n < driving.forces.size(); ++n) {
    const ForceDrive& drive = driving.forces[n];
    check_number(fmt::format("forces/{}/bead", n), drive.bead, type.beads.size(), "bead");
    const double length = drive.direction.norm();
    if (std::abs(length - 1) > axis_tolerance)
      faults.add(fmt::format("{}/forces/{}/direction", place, n),
                 "the direction {} has the length {:.9g}; give a vector other than zero",
                 in_words(drive.direction), length);
  }
  for (std::size_t n = 0; n < driving.bonds.size(); ++n)
    check_number(fmt::format("bonds/{}/bond", n), driving.bonds[n].bond, type.bonds.size(), "bond");
  for (std::size_t n = 0; n < driving.angles.size(); ++n)
    check_number(fmt::format("angles/{}/angle", n), driving.angles[n].angle, type.angles.size(), "angle");
  for (std::size_t n = 0; n < driving.bonds.size(); ++n) {
    const int k = driving.bonds[n].bond;
    if (driving.bonds[n].quantity != BondQuantity::rest_length || k >= std::ssize(type.bonds)) continue;
    const auto [i, j] = type.bonds[k].beads;
    const double shortest =
        type.bonds[k].rest_length - largest_change(driving.bonds, [k](const BondDrive& drive) {
          return drive.bond == k && drive.quantity == BondQuantity::rest_length;
        });
    const double contact = contact_distance(type, i, j);
    if (shortest > contact) continue;
    faults.add(fmt::format("{}/bonds/{}/rest_length", place, n),
               "the rest length falls to {:.6g}, where beads {} and {} overlap; it must stay "
               "greater than {}, the sum of their radii; lower the amplitudes",
               shortest, i + 1, j + 1, contact);
  }
  if (driving.net_force == NetForce::allowed) return;
  for (const auto& [multiple, size] : net_forces(driving)) {
    faults.add(place + "/forces",
               "the {} do not sum to zero; the sum has the size {:.6g}: give the other beads "
               "the opposite force, or set \"net_force\": \"allowed\" to tow the swimmer",
               multiple == 0 ? "constant forces" : fmt::format("forces with the multiple {}", multiple),
               size);
  }
}

void check_types(const std::map<std::string, SwimmerType>& types, Faults& faults) {
  for (const auto& [name, type] : types) {
    const std::string place = "/types/" + name;
    const bool is_three_beads = three_bead_form(type).has_value();
    const std::size_t before = faults.size();
    check_graph(place, type, faults);
    if (faults.size() > before) continue;
    check_bond_lengths(place + (is_three_beads ? "/springs" : "/bonds"), type, faults);
    if (is_three_beads) continue;
    check_connections(place, type, faults);
    check_beads_at_rest(place, type, faults);
    check_driving(place + "/driving", type, faults);
    if (faults.size() == before) check_angles(place, type, faults);
  }
}

void check_own_driving(const Layout& layout, Faults& faults) {
  for (std::size_t i = 0; i < layout.swimmers.size(); ++i) {
    const Swimmer& swimmer = layout.swimmers[i];
    if (!swimmer.driving || !layout.types.contains(swimmer.type)) continue;
    const SwimmerType type = layout.resolved_type(swimmer);
    if (three_bead_form(type)) continue;
    const std::size_t before = faults.size();
    check_driving(swimmer_place(i, "driving"), type, faults);
    if (faults.size() == before) check_angles(fmt::format("/swimmers/{}", i), type, faults);
  }
}

/// Reports starts with another number of beads than the type, or with bonds that are too long.
void check_starts(const Layout& layout, Faults& faults) {
  for (std::size_t s = 0; s < layout.swimmers.size(); ++s) {
    const auto type = layout.types.find(layout.swimmers[s].type);
    if (!layout.swimmers[s].start || type == layout.types.end()) continue;
    const std::vector<Vec3>& places = layout.swimmers[s].start->positions;
    const std::string place = swimmer_place(s, "start/positions");
    if (places.size() != type->second.beads.size()) {
      faults.add(place,
                 "the start has {} positions, but the type \"{}\" has {} beads; give one for each bead",
                 places.size(), type->first, type->second.beads.size());
      continue;
    }
    for (const Bond& bond : type->second.bonds) {
      const auto [i, j] = bond.beads;
      const double length = (places[j] - places[i]).norm();
      if (length <= max_stretch * bond.rest_length) continue;
      faults.add(
          place,
          "beads {} and {} are {:.6g} apart, more than twice the rest length {} of their bond; positions "
          "of a swimmer are not wrapped into the box",
          i + 1, j + 1, length, bond.rest_length);
    }
  }
}

void check_type_names(const Layout& layout, Faults& faults) {
  std::vector<std::string> names;
  for (const auto& [name, type] : layout.types) names.push_back(name);
  for (std::size_t i = 0; i < layout.swimmers.size(); ++i) {
    const std::string& type = layout.swimmers[i].type;
    if (layout.types.count(type) > 0) continue;
    faults.add(swimmer_place(i, "type"), "the swimmer type \"{}\" is not defined under /types{}", type,
               format_suggestion(type, names));
  }
}

void check_ids(const std::vector<Swimmer>& swimmers, Faults& faults) {
  std::unordered_map<int, std::size_t> first_with;
  for (std::size_t i = 0; i < swimmers.size(); ++i) {
    const auto [entry, is_new] = first_with.try_emplace(swimmers[i].id, i);
    if (is_new) continue;
    faults.add(swimmer_place(i, "id"),
               "the id {} is already used by /swimmers/{}; give each swimmer another id", swimmers[i].id,
               entry->second);
  }
}

void check_axes(const std::vector<Swimmer>& swimmers, Faults& faults) {
  for (std::size_t i = 0; i < swimmers.size(); ++i) {
    if (swimmers[i].turn) {
      const double size = swimmers[i].turn->norm();
      if (std::abs(size - 1) > axis_tolerance)
        faults.add(swimmer_place(i, "orientation"),
                   "the quaternion has the norm {:.9g}, but must have the norm 1", size);
      continue;
    }
    const double length = swimmers[i].axis.norm();
    if (std::abs(length - 1) <= axis_tolerance) continue;
    const std::string remedy =
        length > 0 ? "; divided by its length it is " + in_words(swimmers[i].axis / length) : "";
    faults.add(swimmer_place(i, "axis"), "the axis {} has the length {:.9g}, but must be a unit vector{}",
               in_words(swimmers[i].axis), length, remedy);
  }
}

void check_positions(const Layout& layout, Faults& faults) {
  const Vec3& box = layout.domain.box->lengths;
  for (std::size_t i = 0; i < layout.swimmers.size(); ++i) {
    const Vec3& x = layout.swimmers[i].position;
    if ((x.array() >= 0).all() && (x.array() <= box.array()).all()) continue;
    const auto type = layout.types.find(layout.swimmers[i].type);
    const bool is_three_beads = type == layout.types.end() || three_bead_form(type->second);
    faults.add(swimmer_place(i, "position"),
               "the position {} of {} lies outside the box; each coordinate must be "
               "between 0 and the box length, {}",
               in_words(x), is_three_beads ? "bead 2" : "the origin of the type's frame", in_words(box));
  }
}

/// Reports walls that do not move along themselves, or that move along an axis with other no-slip walls: at
/// the edges between them the lattice would lose and gain fluid.
void check_wall_velocities(const Box& domain, Faults& faults) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto check = [&](const Vec3& velocity, const char* key) {
      if (velocity[axis] != 0)
        faults.add(fmt::format("/domain/boundary/{}/no-slip/{}", axis, key),
                   "the velocity {} has a component across the wall, along {}; walls move "
                   "along themselves: set this component to 0",
                   in_words(velocity), "xyz"[axis]);
      for (int along = 0; along < 3; ++along) {
        if (along == axis || velocity[along] == 0 || domain.boundary[along] != Boundary::no_slip) continue;
        faults.add(fmt::format("/domain/boundary/{}/no-slip/{}/{}", axis, key, along),
                   "the wall cannot move along {}, because no-slip walls close this axis; "
                   "set this component to 0",
                   "xyz"[along]);
      }
    };
    check(domain.walls[axis].lower, "lower_velocity");
    check(domain.walls[axis].upper, "upper_velocity");
  }
}

/// Reports a body force that no wall balances, or that acts on a wall.
void check_body_force(const Layout& layout, Faults& faults) {
  if (layout.body_force.isZero(0)) return;
  if (!layout.domain.box || std::ranges::count(layout.domain.box->boundary, Boundary::no_slip) == 0) {
    faults.add("/body_force",
               "there are no no-slip walls, so that the body force would accelerate the fluid without "
               "end; give an axis the boundary no-slip, or remove the key");
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (layout.body_force[axis] == 0 || layout.domain.box->is_periodic(axis)) continue;
    faults.add(fmt::format("/body_force/{}", axis),
               "the fluid cannot flow along {}, because walls close this axis; set this component to 0",
               "xyz"[axis]);
  }
}

/// Reports a background flow that is compressible, or that walls would stop.
void check_flow(const Layout& layout, Faults& faults) {
  if (layout.flow.is_zero()) return;
  const Eigen::Matrix3d& gradient = layout.flow.velocity_gradient;
  constexpr double roundoff = 1e-12;
  if (std::abs(gradient.trace()) > roundoff * gradient.cwiseAbs().maxCoeff())
    faults.add("/flow/velocity_gradient",
               "the trace is {:.6g}, but an incompressible flow has the trace 0; change an "
               "element of the diagonal",
               gradient.trace());
  if (layout.domain.box)
    faults.add("/flow",
               "a background flow is unbounded, but the domain is a box; set the domain to null or to a "
               "half-space, or replace the flow by no-slip walls that move or a body force");
  if (!layout.domain.half_space) return;
  const int across = layout.domain.half_space->axis;
  if (!layout.flow.velocity.isZero(0))
    faults.add("/flow/velocity", "the flow must be 0 on the no-slip wall at {} = 0; set this velocity to 0",
               "xyz"[across]);
  for (int c = 0; c < 3; ++c) {
    for (int by = 0; by < 3; ++by) {
      if (gradient(c, by) == 0 || (by == across && c != across)) continue;
      faults.add(fmt::format("/flow/velocity_gradient/{}/{}", c, by),
                 "over a no-slip wall at {0} = 0 only shear along the wall is possible, a "
                 "velocity along {1} or {2} that changes along {0}; set this element to 0",
                 "xyz"[across], "xyz"[across == 0 ? 1 : 0], "xyz"[across == 2 ? 1 : 2]);
    }
  }
}

/// Reports beads that are not completely above the wall of a half-space.
void check_heights(const HalfSpace& half_space, const std::vector<PlacedBead>& beads, Faults& faults) {
  for (const PlacedBead& bead : beads) {
    const double height = half_space.height(bead.centre);
    if (height > bead.radius) continue;
    faults.add(swimmer_place(bead.swimmer, "position"),
               "bead {} of radius {} at {} is not completely in the fluid: its centre is {:.6g} above "
               "the wall at {} = 0, but must be more than its radius above; move the swimmer",
               bead.bead + 1, bead.radius, in_words(bead.centre), height, "xyz"[half_space.axis]);
  }
}

void check_walls(const Box& domain, const std::vector<PlacedBead>& beads, Faults& faults) {
  for (const PlacedBead& bead : beads) {
    for (int axis = 0; axis < 3; ++axis) {
      if (domain.is_periodic(axis)) continue;
      const double lowest = bead.radius;
      const double highest = domain.lengths[axis] - bead.radius;
      if (bead.centre[axis] > lowest && bead.centre[axis] < highest) continue;
      faults.add(swimmer_place(bead.swimmer, "position"),
                 "bead {} of radius {} at {} is not completely between the walls along {}: its centre "
                 "must be between {} and {}; move the swimmer or enlarge the box",
                 bead.bead + 1, bead.radius, in_words(bead.centre), "xyz"[axis], lowest, highest);
    }
  }
}

std::string bead_in_words(const PlacedBead& bead, const Layout& layout) {
  return fmt::format("bead {} of swimmer {} at {}", bead.bead + 1, layout.swimmers[bead.swimmer].id,
                     in_words(bead.centre));
}

void check_overlaps(const Layout& layout, const std::vector<PlacedBead>& beads, Faults& faults) {
  for (const BeadPair& pair : overlapping_pairs(beads, layout.domain.box, max_overlaps)) {
    const PlacedBead& first = beads[pair.first];
    const PlacedBead& second = beads[pair.second];
    const bool through_boundary =
        (first.centre - second.centre).norm() > pair.distance * (1 + 1e-9) || &first == &second;
    const std::string other = &first == &second ? "its own periodic image" : bead_in_words(second, layout);
    const bool is_by_drives = first.swimmer == second.swimmer && !through_boundary;
    faults.add(swimmer_place(first.swimmer, "position"),
               "{} overlaps {}{}: their centres are {:.6g} apart, but must be more than {:.6g} apart",
               bead_in_words(first, layout), other,
               through_boundary ? " through the periodic boundary"
               : is_by_drives   ? " on the shape that its drives prescribe at time 0"
                                : "",
               pair.distance, first.radius + second.radius);
  }
}

}  // namespace

std::vector<LayoutFault> check_layout(const Layout& layout) {
  Faults faults;
  check_units(layout.units, faults);
  check_types(layout.types, faults);
  if (faults.empty()) check_own_driving(layout, faults);
  check_type_names(layout, faults);
  if (faults.empty()) check_starts(layout, faults);
  check_ids(layout.swimmers, faults);
  check_axes(layout.swimmers, faults);
  if (layout.domain.box) check_wall_velocities(*layout.domain.box, faults);
  check_body_force(layout, faults);
  check_flow(layout, faults);
  if (layout.domain.box) check_positions(layout, faults);
  if (faults.empty())
    if (const std::string fault = range_fault(layout); !fault.empty()) faults.push_back({"", fault});
  if (!faults.empty()) return faults;

  const std::vector<PlacedBead> beads = placed_beads(layout);
  if (layout.domain.box) check_walls(*layout.domain.box, beads, faults);
  if (layout.domain.half_space) check_heights(*layout.domain.half_space, beads, faults);
  if (faults.empty()) check_overlaps(layout, beads, faults);
  std::unordered_set<std::string>
      seen;  // keeps one fault of a misplaced swimmer, which has several faulty beads
  std::erase_if(faults, [&seen](const LayoutFault& fault) { return !seen.insert(fault.place).second; });
  return faults;
}

void normalise_axes(Layout& layout) {
  // Axes whose length is 1 within roundoff are unchanged, so that a layout is read and written without any
  // change of bits.
  constexpr double roundoff = 4 * std::numeric_limits<double>::epsilon();
  for (Swimmer& swimmer : layout.swimmers) {
    if (swimmer.turn) {
      const double norm_excess = std::abs(swimmer.turn->norm() - 1);
      if (norm_excess > roundoff && norm_excess <= axis_tolerance) swimmer.turn->normalize();
      swimmer.axis = swimmer.turn->toRotationMatrix().col(0);
      continue;
    }
    const double excess = std::abs(swimmer.axis.norm() - 1);
    if (excess > roundoff && excess <= axis_tolerance) swimmer.axis.normalize();
  }
}

}  // namespace beadswim
