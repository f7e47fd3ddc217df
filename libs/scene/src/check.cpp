#include "beadswim/scene/check.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "beadswim/core/nearest_name.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

constexpr double axis_tolerance = 1e-6;
constexpr std::size_t max_overlaps = 1000;

using Faults = std::vector<LayoutFault>;

std::string in_words(const Vec3& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]);
}

std::string swimmer_place(std::size_t index, const char* key) {
  return fmt::format("/swimmers/{}/{}", index, key);
}

void check_unit(Quantity quantity, const Units::Unit& unit, const char* place, Faults& faults) {
  const Units::Unit* known = find_known_unit(quantity, unit.name);
  constexpr double tolerance = 1e-9;
  if (!known || std::abs(unit.si_factor / known->si_factor - 1) < tolerance) return;
  faults.push_back(
      {fmt::format("{}/si_factor", place),
       fmt::format("the factor {} is wrong: one {} is {} in SI units; give that factor or another unit name",
                   unit.si_factor, unit.name, known->si_factor)});
}

void check_units(const Units& units, Faults& faults) {
  if (units.lattice) return;
  check_unit(Quantity::length, units.length, "/units/length", faults);
  check_unit(Quantity::time, units.time, "/units/time", faults);
  check_unit(Quantity::mass, units.mass, "/units/mass", faults);
}

void check_types(const std::map<std::string, SwimmerType>& types, Faults& faults) {
  for (const auto& [name, type] : types) {
    const char* key = three_bead_form(type) ? "springs" : "bonds";
    for (std::size_t k = 0; k < type.bonds.size(); ++k) {
      const auto [i, j] = type.bonds[k].beads;
      const double length = type.bonds[k].rest_length;
      const double contact = type.beads[i].radius + type.beads[j].radius;
      if (length > contact) continue;
      faults.push_back({fmt::format("/types/{}/{}/{}/rest_length", name, key, k),
                        fmt::format("with the rest length {}, beads {} and {} overlap; the rest length must "
                                    "be greater than {}, the sum of their radii",
                                    length, i + 1, j + 1, contact)});
    }
  }
}

void check_type_names(const Layout& layout, Faults& faults) {
  std::vector<std::string> names;
  for (const auto& [name, type] : layout.types) names.push_back(name);
  for (std::size_t i = 0; i < layout.swimmers.size(); ++i) {
    const std::string& type = layout.swimmers[i].type;
    if (layout.types.count(type) > 0) continue;
    faults.push_back(
        {swimmer_place(i, "type"), fmt::format("the swimmer type \"{}\" is not defined under /types{}", type,
                                               format_suggestion(type, names))});
  }
}

void check_ids(const std::vector<Swimmer>& swimmers, Faults& faults) {
  std::unordered_map<int, std::size_t> first_with;
  for (std::size_t i = 0; i < swimmers.size(); ++i) {
    const auto [entry, is_new] = first_with.try_emplace(swimmers[i].id, i);
    if (is_new) continue;
    faults.push_back({swimmer_place(i, "id"),
                      fmt::format("the id {} is already used by /swimmers/{}; give each swimmer another id",
                                  swimmers[i].id, entry->second)});
  }
}

void check_axes(const std::vector<Swimmer>& swimmers, Faults& faults) {
  for (std::size_t i = 0; i < swimmers.size(); ++i) {
    const double length = swimmers[i].axis.norm();
    if (std::abs(length - 1) <= axis_tolerance) continue;
    const std::string remedy =
        length > 0 ? "; divided by its length it is " + in_words(swimmers[i].axis / length) : "";
    faults.push_back({swimmer_place(i, "axis"),
                      fmt::format("the axis {} has the length {:.9g}, but must be a unit vector{}",
                                  in_words(swimmers[i].axis), length, remedy)});
  }
}

void check_positions(const Box& domain, const std::vector<Swimmer>& swimmers, Faults& faults) {
  for (std::size_t i = 0; i < swimmers.size(); ++i) {
    const Vec3& x = swimmers[i].position;
    if ((x.array() >= 0).all() && (x.array() <= domain.lengths.array()).all()) continue;
    faults.push_back(
        {swimmer_place(i, "position"), fmt::format("the position {} of bead 2 lies outside the box; each "
                                                   "coordinate must be between 0 and the box length, {}",
                                                   in_words(x), in_words(domain.lengths))});
  }
}

void check_walls(const Box& domain, const std::vector<PlacedBead>& beads, Faults& faults) {
  constexpr std::array<char, 3> axis_names{'x', 'y', 'z'};
  for (const PlacedBead& bead : beads) {
    for (int axis = 0; axis < 3; ++axis) {
      if (domain.is_periodic(axis)) continue;
      const double lowest = bead.radius;
      const double highest = domain.lengths[axis] - bead.radius;
      if (bead.centre[axis] > lowest && bead.centre[axis] < highest) continue;
      faults.push_back(
          {swimmer_place(bead.swimmer, "position"),
           fmt::format("bead {} of radius {} at {} is not completely between the walls along {}: its centre "
                       "must be between {} and {}; move the swimmer or enlarge the box",
                       bead.bead + 1, bead.radius, in_words(bead.centre), axis_names[axis], lowest,
                       highest)});
    }
  }
}

std::string bead_in_words(const PlacedBead& bead, const Layout& layout) {
  return fmt::format("bead {} of swimmer {} at {}", bead.bead + 1, layout.swimmers[bead.swimmer].id,
                     in_words(bead.centre));
}

void check_overlaps(const Layout& layout, const std::vector<PlacedBead>& beads, Faults& faults) {
  for (const BeadPair& pair : overlapping_pairs(beads, layout.domain, max_overlaps)) {
    const PlacedBead& first = beads[pair.first];
    const PlacedBead& second = beads[pair.second];
    const bool through_boundary =
        (first.centre - second.centre).norm() > pair.distance * (1 + 1e-9) || &first == &second;
    const std::string other = &first == &second ? "its own periodic image" : bead_in_words(second, layout);
    faults.push_back(
        {swimmer_place(first.swimmer, "position"),
         fmt::format("{} overlaps {}{}: their centres are {:.6g} apart, but must be more than {:.6g} apart",
                     bead_in_words(first, layout), other,
                     through_boundary ? " through the periodic boundary" : "", pair.distance,
                     first.radius + second.radius)});
  }
}

/// Keeps the first fault of each place in the document, because a misplaced swimmer usually has several
/// faulty beads.
void keep_first_of_each_place(Faults& faults) {
  std::unordered_set<std::string> seen;
  std::erase_if(faults, [&seen](const LayoutFault& fault) { return !seen.insert(fault.place).second; });
}

}  // namespace

std::vector<LayoutFault> check_layout(const Layout& layout) {
  Faults faults;
  check_units(layout.units, faults);
  check_types(layout.types, faults);
  check_type_names(layout, faults);
  check_ids(layout.swimmers, faults);
  check_axes(layout.swimmers, faults);
  if (layout.domain) check_positions(*layout.domain, layout.swimmers, faults);
  if (!faults.empty()) return faults;

  const std::vector<PlacedBead> beads = placed_beads(layout);
  if (layout.domain) check_walls(*layout.domain, beads, faults);
  if (faults.empty()) check_overlaps(layout, beads, faults);
  keep_first_of_each_place(faults);
  return faults;
}

void normalise_axes(Layout& layout) {
  // Axes whose length is 1 within roundoff are unchanged, so that a layout is read and written without any
  // change of bits.
  constexpr double roundoff = 4 * std::numeric_limits<double>::epsilon();
  for (Swimmer& swimmer : layout.swimmers) {
    const double excess = std::abs(swimmer.axis.norm() - 1);
    if (excess > roundoff && excess <= axis_tolerance) swimmer.axis.normalize();
  }
}

}  // namespace beadswim
