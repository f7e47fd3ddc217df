#pragma once

#include <array>
#include <complex>

#include "beadswim/swimmers/swimmer_type.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/collinear_mobility.hpp"

namespace beadswim {

/// A swimmer that moves along its own line: all that theory needs, in any coherent units.
/// Lengths, forces and velocities count as positive from bead 1 to bead 3.
struct CollinearSwimmer {
  std::array<double, 3> radius{};     ///< lambda_i of beads 1, 2, 3 [length]
  std::array<double, 3> density{};    ///< of the beads [mass/length^3]; matters with inertia only
  std::array<double, 2> arm{};        ///< rest lengths l_i [length]
  std::array<double, 2> stiffness{};  ///< k_i [mass/time^2]
  std::array<double, 2> damping{};    ///< dashpots c_i [mass/time]
  std::array<double, 2> amplitude{};  ///< A, B of (2.1), along the swimmer [mass length/time^2]
  double phase = 0;                   ///< alpha of (2.1) [radian]
  double phase_offset = 0;            ///< phi, which turns the phases of arms and nothing else [radian]
  double period = 0;                  ///< T [time]
  double viscosity = 0;               ///< eta, dynamic [mass/(length time)]

  double angular_frequency() const;  ///< omega = 2 pi / T [radian/time]

  bool operator==(const CollinearSwimmer&) const = default;
};

/// The collinear problem of a swimmer of `type` whose beads lie along the unit vector `axis`, in fluid of
/// dynamic `viscosity`. The angular spring does not enter: it is at rest in a straight swimmer. A driving of
/// frame `lab` acts along x, so for axis -x amplitudes change sign.
/// Throws InputError for a driving of frame `lab` and an axis that is not along x (the motion leaves the
/// line), and for a spring without stiffness (the arm's mean length is not held, so nothing is periodic).
CollinearSwimmer collinear_swimmer(const SwimmerType& type, const Vec3& axis, double viscosity);

/// alpha = sqrt(i omega rho / eta), real part above 0: 1/alpha is the complex depth to which vorticity
/// reaches in fluid of that density [1/length].
std::complex<double> inverse_penetration_depth(const CollinearSwimmer& swimmer, double fluid_density);

/// Places of the three beads at rest, bead 2 at the origin.
LinePositions rest_positions(const CollinearSwimmer& swimmer);

/// Gaps between the surfaces of neighbouring beads at rest, below 0 where they overlap [length].
std::array<double, 2> gaps_at_rest(const CollinearSwimmer& swimmer);

/// Smallest distance of neighbouring beads at rest over the mean of their two radii: l/lambda for equal
/// beads and arms, 2 for touching ones.
double separation_ratio(const CollinearSwimmer& swimmer);

/// The swimmer's mobility at rest, its pairs interacting by `law`.
CollinearMobility rest_mobility(const CollinearSwimmer& swimmer, PairLaw law);

}  // namespace beadswim
