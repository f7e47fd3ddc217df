#include "beadswim/swimmers/three_bead_swimmer.hpp"

#include "beadswim/core/error.hpp"

namespace beadswim {

Driving drives(const ThreeBeadDriving& three) {
  const auto& [a, b] = three.amplitude;
  const double alpha = three.phase;
  Driving driving{.period = three.period, .phase_offset = three.phase_offset, .frame = three.frame};
  if (three.frame == DrivingFrame::body) {
    driving.bonds = {{.bond = 0, .harmonics = {{.amplitude = a}}},
                     {.bond = 1, .harmonics = {{.amplitude = -b, .phase = alpha}}}};
  } else {
    driving.forces = {{.bead = 0, .harmonics = {{.amplitude = a}}},
                      {.bead = 1, .harmonics = {{.amplitude = -a}, {.amplitude = -b, .phase = alpha}}},
                      {.bead = 2, .harmonics = {{.amplitude = b, .phase = alpha}}}};
  }
  return driving;
}

SwimmerType swimmer_type(const ThreeBeadSwimmer& swimmer) {
  const auto& [first, second] = swimmer.springs;
  SwimmerType type;
  const std::array places{-first.rest_length, 0.0, second.rest_length};
  for (int b = 0; b < 3; ++b) type.beads.push_back({swimmer.beads[b], places[b] * Vec3::UnitX()});
  type.bonds = {{first, {0, 1}}, {second, {1, 2}}};
  type.angles = {{.beads = {0, 1, 2}, .stiffness = swimmer.angular_stiffness, .rest = 0}};
  type.driving = drives(swimmer.driving);
  return type;
}

std::optional<ThreeBeadDriving> three_bead_form(const Driving& driving) {
  ThreeBeadDriving three{
      .period = driving.period, .frame = driving.frame, .phase_offset = driving.phase_offset};
  const auto first = [](const auto& drive) {
    return drive.harmonics.empty() ? Harmonic() : drive.harmonics.front();
  };
  if (driving.forces.size() == 3) {
    three.amplitude = {first(driving.forces[0]).amplitude, first(driving.forces[2]).amplitude};
    three.phase = first(driving.forces[2]).phase;
  } else if (driving.bonds.size() == 2) {
    three.amplitude = {first(driving.bonds[0]).amplitude, -first(driving.bonds[1]).amplitude};
    three.phase = first(driving.bonds[1]).phase;
  }
  if (drives(three) != driving) return std::nullopt;
  return three;
}

std::optional<ThreeBeadSwimmer> three_bead_form(const SwimmerType& type) {
  if (type.beads.size() != 3 || type.bonds.size() != 2 || type.angles.size() != 1) return std::nullopt;
  const std::optional<ThreeBeadDriving> driving = three_bead_form(type.driving);
  if (!driving) return std::nullopt;
  ThreeBeadSwimmer three{.springs = {type.bonds[0], type.bonds[1]},
                         .angular_stiffness = type.angles[0].stiffness,
                         .driving = *driving};
  for (int b = 0; b < 3; ++b) three.beads[b] = type.beads[b];
  const SwimmerType same = swimmer_type(three);
  if (same.beads != type.beads || same.bonds != type.bonds || same.angles != type.angles) return std::nullopt;
  return three;
}

ThreeBeadSwimmer three_beads(const SwimmerType& type) {
  if (std::optional<ThreeBeadSwimmer> three = three_bead_form(type)) return *three;
  throw InputError(
      "the swimmer is not the paper's (three beads in a line with two springs, one angular spring and forces "
      "A, B along the line); describe it in version 2 of layouts");
}

}  // namespace beadswim
