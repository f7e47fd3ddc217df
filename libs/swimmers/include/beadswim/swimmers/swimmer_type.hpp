#pragma once

#include <array>
#include <optional>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/core/vec3.hpp"

// Parameters of a swimmer of any shape: a graph of beads, bonds, angles and drives. Quantities are in any
// coherent unit system: the units of the layout in layouts and theory, lattice units inside a resolved run.
// Beads, bonds and angles are numbered from 0, in documents and messages from 1.

namespace beadswim {

constexpr int max_beads = 64;  ///< largest number of beads of a swimmer

struct Bead {
  double radius = 0;   ///< [length]
  double density = 0;  ///< [mass/length^3]

  bool operator==(const Bead&) const = default;

  BEADSWIM_FIELDS(radius, density)
};

struct BeadAtRest : Bead {
  Vec3 at = Vec3::Zero();  ///< centre at rest, in the frame of the type [length]

  bool operator==(const BeadAtRest&) const = default;

  static void visit_fields(auto&& visit, auto& bead) {
    Bead::visit_fields(visit, bead);
    visit("at", bead.at);
  }
};

struct Spring {
  double stiffness = 0;    ///< k [mass/time^2]
  double rest_length = 0;  ///< l, distance of the bead centres [length]
  double damping = 0;      ///< c of the dashpot parallel to the spring [mass/time]; 0: no dashpot

  bool operator==(const Spring&) const = default;

  BEADSWIM_FIELDS(stiffness, rest_length, damping)
};

/// Spring between two beads.
struct Bond : Spring {
  std::array<int, 2> beads{};

  bool operator==(const Bond&) const = default;

  static void visit_fields(auto&& visit, auto& bond) {
    visit("beads", bond.beads, counted_from_one);
    Spring::visit_fields(visit, bond);
  }
};

/// Angular spring with the energy U = K_A (theta - rest)^2/2. theta in [0, pi] is the angle between the
/// directions from the first bead to the second and from the second to the third; 0 for three beads in line.
/// With a normal, the spring is a hinge, and theta is counted from -pi to pi about the normal (hinges.hpp).
struct Angle {
  std::array<int, 3> beads{};
  double stiffness = 0;  ///< K_A [energy]
  double rest = 0;       ///< [radian]
  std::optional<Vec3> normal{};  ///< unit vector in the frame of the type, across the plane of the hinge

  bool operator==(const Angle&) const = default;

  BEADSWIM_FIELDS((beads, counted_from_one), stiffness, rest, (normal, omitted_if_none, of_unit_length))
};

/// A sin(n (w t + phi) + phase): amplitude A, multiple n of the angular frequency w, phase offset phi of the
/// driving.
struct Harmonic {
  double amplitude = 0;
  double phase = 0;  ///< [radian]
  int multiple = 1;

  bool operator==(const Harmonic&) const = default;

  BEADSWIM_FIELDS(amplitude, (phase, omitted_if(0)), (multiple, omitted_if(1)))
};

/// Force on a bead along a direction: a constant and harmonics [mass length/time^2].
struct ForceDrive {
  int bead = 0;
  Vec3 direction = Vec3::UnitX();  ///< unit vector in the frame of the driving (DrivingFrame)
  double constant = 0;
  std::vector<Harmonic> harmonics{};

  bool operator==(const ForceDrive&) const = default;

  BEADSWIM_FIELDS((bead, counted_from_one), (direction, of_unit_length), (constant, omitted_if(0)),
                  (harmonics, omitted_if_none))
};

/// Quantity of a bond that a drive adds to.
enum class BondQuantity {
  tension,      ///< [mass length/time^2]; a positive tension pulls the two beads together
  rest_length,  ///< [length]
};

template <>
inline constexpr auto name_table<BondQuantity> = std::to_array<NamedValue<BondQuantity>>(
    {{BondQuantity::tension, "tension"}, {BondQuantity::rest_length, "rest_length"}});

struct BondDrive {
  int bond = 0;
  BondQuantity quantity = BondQuantity::tension;
  std::vector<Harmonic> harmonics{};

  bool operator==(const BondDrive&) const = default;

  BEADSWIM_FIELDS((bond, counted_from_one), quantity, harmonics)
};

/// Change of the rest angle of an angular spring [radian].
struct AngleDrive {
  int angle = 0;
  std::vector<Harmonic> harmonics{};

  bool operator==(const AngleDrive&) const = default;

  static void visit_fields(auto&& visit, auto& drive) {
    visit("angle", drive.angle, counted_from_one);
    visit("rest", drive.harmonics);
  }
};

/// Frame in which the directions of driving forces are constant.
enum class DrivingFrame {
  lab,           ///< the frame of the box, for every orientation of the swimmer
  initial_axis,  ///< the frame of each swimmer at the start of the run
  body,          ///< the present frame of the swimmer
};

template <>
inline constexpr auto name_table<DrivingFrame> = std::to_array<NamedValue<DrivingFrame>>(
    {{DrivingFrame::lab, "lab"}, {DrivingFrame::initial_axis, "initial-axis"}, {DrivingFrame::body, "body"}});

/// Sum of the driving forces of a swimmer.
enum class NetForce { zero, allowed };

template <>
inline constexpr auto name_table<NetForce> =
    std::to_array<NamedValue<NetForce>>({{NetForce::zero, "zero"}, {NetForce::allowed, "allowed"}});

/// Drives with a common period. Forces, tensions, rest lengths and rest angles are functions of time alone.
struct Driving {
  double period = 0;        ///< T = 2 pi/w [time]
  double phase_offset = 0;  ///< phi [radian]; in a swarm, phi can differ between swimmers
  DrivingFrame frame = DrivingFrame::lab;
  std::vector<ForceDrive> forces{};
  std::vector<BondDrive> bonds{};
  std::vector<AngleDrive> angles{};
  NetForce net_force = NetForce::zero;  ///< zero: the forces sum to zero at all times

  bool operator==(const Driving&) const = default;

  BEADSWIM_FIELDS(period, (phase_offset, omitted_if(0)), frame, (forces, omitted_if_none),
                  (bonds, omitted_if_none), (angles, omitted_if_none),
                  (net_force, omitted_if(NetForce::zero)))
};

/// Calls visit(harmonic) for each harmonic of all drives.
void for_each_harmonic(auto& driving, auto&& visit) {
  const auto visit_those_of = [&visit](auto& drives) {
    for (auto& drive : drives)
      for (auto& harmonic : drive.harmonics) visit(harmonic);
  };
  visit_those_of(driving.forces);
  visit_those_of(driving.bonds);
  visit_those_of(driving.angles);
}

/// Largest permitted length of a bond, divided by its rest length. A longer bond ends a run.
constexpr double max_stretch = 2;

struct SwimmerType {
  std::vector<BeadAtRest> beads;
  std::vector<Bond> bonds;
  std::vector<Angle> angles;
  Driving driving;

  bool operator==(const SwimmerType&) const = default;

  BEADSWIM_FIELDS(beads, (bonds, omitted_if_none), (angles, omitted_if_none), driving)
};

}  // namespace beadswim
