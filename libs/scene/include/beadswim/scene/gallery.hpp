#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "beadswim/scene/layout.hpp"

// A gallery of swimmer types from the literature. Each struct lists the parameters of one kind of swimmer,
// with default values for a fluid of density 1 and kinematic viscosity 1/3. A list has one value for all
// beads, arms or sides, or one value for each. nullopt or an empty list stands for a value that follows from
// the others; a is the largest radius. By default bonds are stiff: k = 1000 gamma w prescribes a length to
// 0.1 %, with the drag coefficient gamma of the largest bead and the angular frequency w. Chains of length L
// stay straight with K_A = k L^2. Page: docs/shapes.md.

namespace beadswim {

/// Parameters of all kinds.
struct GallerySwimmer {
  std::vector<double> radius{4};       ///< of the beads [length]
  std::optional<double> bead_density;  ///< nullopt: that of the fluid [mass/length^3]
  double period = 4800;                ///< T of the driving [time]
};

/// Parameters of kinds with bonds.
struct BondedSwimmer : GallerySwimmer {
  std::optional<double> stiffness;  ///< k of the bonds; nullopt: 1000 gamma w [mass/time^2]
  double damping = 0;               ///< c of the bonds [mass/time]
};

/// Two beads, whose distance oscillates: L = l + A sin(w t). Purcell, Am. J. Phys. 45 (1977) 3: without
/// inertia it does not swim.
struct Dumbbell : BondedSwimmer {
  std::optional<double> arm;        ///< l; nullopt: 5 a [length]
  std::optional<double> amplitude;  ///< A; nullopt: l/5 [length]
};

/// Three beads at the corners of an equilateral triangle in the plane z = 0, whose sides oscillate: L_k = l +
/// A_k sin(w t - (k - 1) phase). Rizvi, Farutin and Misbah, Phys. Rev. E 97 (2018) 023102: it rotates if its
/// sides oscillate a third of a period apart.
struct Triangle : BondedSwimmer {
  std::optional<double> arm;                ///< l; nullopt: 5 a [length]
  std::vector<double> amplitude;            ///< A_k; empty: l/5 [length]
  double phase = 2 * std::numbers::pi / 3;  ///< by which a side is behind the previous one [radian]
};

/// Three beads in a line whose arms have prescribed lengths: L_1 = l_1 + A_1 sin(w t + phase), L_2 = l_2 +
/// A_2 sin(w t). Najafi and Golestanian, Phys. Rev. E 69 (2004) 062901.
struct PrescribedThreeBead : BondedSwimmer {
  std::vector<double> arm;                  ///< l_1, l_2; empty: 5 a [length]
  std::vector<double> amplitude;            ///< A_1, A_2; empty: a fifth of the arm [length]
  double phase = std::numbers::pi / 2;      ///< by which arm 1 is ahead of arm 2 [radian]
  std::optional<double> angular_stiffness;  ///< K_A; nullopt: 10 k l^2 with the mean arm l [energy]
};

/// Three straight links of beads with two hinges, bent to opposite sides in the plane z = 0, as a Z. The
/// angles of the hinges oscillate: theta_1 = theta_0 + A sin(w t), theta_2 = theta_0 + A sin(w t + phase).
/// Hinges that pass straight have a normal, by which their angles are signed. Purcell, Am. J. Phys. 45
/// (1977) 3.
struct PurcellChain : BondedSwimmer {
  /// With the beads of the hinges, at least 2: of the outer links and of the middle one.
  std::vector<int> beads_per_link{4};
  std::optional<double> arm;                    ///< distance of neighbouring beads; nullopt: 2.5 a [length]
  double rest_angle = std::numbers::pi / 3;     ///< theta_0; 0: straight [radian]
  double amplitude = 2 * std::numbers::pi / 9;  ///< A [radian]
  double phase = std::numbers::pi / 2;          ///< by which hinge 2 is ahead of hinge 1 [radian]
  std::optional<double> angular_stiffness;      ///< K_A; nullopt: k L^2 of one link [energy]
};

/// Straight elastic chain of beads along x. A couple of forces, A sin(w t) along y on the last bead and
/// -A sin(w t) on its neighbour, swings the end; waves of bending run to the other end and push the chain
/// along x. nullopt for the stiffness of the bonds: that of others, or 100 A divided by their length, if this
/// is more. Wiggins and Goldstein, Phys. Rev. Lett. 80 (1998) 3879; Dreyfus et al., Nature 437 (2005) 862.
struct Flagellum : BondedSwimmer {
  int beads = 16;                           ///< at least 3
  std::optional<double> arm;                ///< distance of neighbouring beads; nullopt: 2.5 a [length]
  double sperm_number = 3;                  ///< of a slender rod with these beads, sperm_number()
  std::optional<double> angular_stiffness;  ///< K_A; nullopt: that of `sperm_number` [energy]
  std::optional<double> amplitude;  ///< A; nullopt: K_A S/(2 L) min(1, (S/2)^3), S: sperm number [force]
  DrivingFrame frame = DrivingFrame::initial_axis;
};

/// One bead with the force F + A sin(w t) along a direction. Stokes (1851).
struct TowedSphere : GallerySwimmer {
  Vec3 direction = Vec3::UnitX();  ///< in the frame of the box
  std::optional<double> force;  ///< F; nullopt: 6 pi eta a^2/T, which moves the bead by a radius in a period
  double amplitude = 0;         ///< A [force]
};

/// Straight elastic chain of beads along x, all with the same constant force F along a direction, as a fibre
/// that settles. Cosentino Lagomarsino, Pagonabarraga and Lowe, Phys. Rev. Lett. 94 (2005) 148104.
struct TowedChain : BondedSwimmer {
  int beads = 8;                            ///< at least 2
  std::optional<double> arm;                ///< distance of neighbouring beads; nullopt: 2.5 a [length]
  Vec3 direction = Vec3::UnitY();           ///< in the frame of the box
  std::optional<double> force;              ///< F on each bead; nullopt: as that of a TowedSphere
  std::optional<double> angular_stiffness;  ///< K_A; nullopt: k L^2 of the chain [energy]
};

/// Returns the sperm number S = L (zeta w/(K_A d))^(1/4) of a chain of beads. L: length [length]; d: distance
/// of neighbouring beads; zeta = 4 pi eta/(ln(L/a) + 1/2): drag coefficient per length across a slender rod
/// of radius a [mass/(length time)].
double sperm_number(const Flagellum& flagellum, double angular_stiffness, const Fluid& fluid);

/// Return the type with these parameters, in a coherent unit system. Its beads at rest have the places that
/// driven lengths and angles prescribe at time 0, so that a run begins without a jump. The origin of its
/// frame is the mean position of the beads of a triangle or a straight chain, the middle of the middle link
/// of Purcell's chain, bead 2 of three in a line, and the midpoint of a dumbbell.
SwimmerType swimmer_type(const Dumbbell& dumbbell, const Fluid& fluid);
SwimmerType swimmer_type(const Triangle& triangle, const Fluid& fluid);
SwimmerType swimmer_type(const PrescribedThreeBead& swimmer, const Fluid& fluid);
SwimmerType swimmer_type(const PurcellChain& chain, const Fluid& fluid);
SwimmerType swimmer_type(const Flagellum& flagellum, const Fluid& fluid);
SwimmerType swimmer_type(const TowedSphere& sphere, const Fluid& fluid);
SwimmerType swimmer_type(const TowedChain& chain, const Fluid& fluid);

}  // namespace beadswim
