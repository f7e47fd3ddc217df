#pragma once

#include <array>
#include <complex>

#include "beadswim/swimmers/swimmer_type.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/collinear_mobility.hpp"

namespace beadswim {

/// A swimmer whose beads stay on a line, with all parameters that theory needs, in any coherent units.
/// Coordinates, forces and velocities are positive from bead 1 towards bead 3.
struct CollinearSwimmer {
  std::array<double, 3> radius{};     ///< lambda_i of beads 1, 2, 3 [length]
  std::array<double, 3> density{};    ///< bead density [mass/length^3]; used only with inertia
  std::array<double, 2> arm{};        ///< rest lengths l_i [length]
  std::array<double, 2> stiffness{};  ///< k_i [mass/time^2]
  std::array<double, 2> damping{};    ///< c_i of the dashpots [mass/time]
  std::array<double, 2> amplitude{};  ///< A, B of (2.1), component along the swimmer [mass length/time^2]
  double phase = 0;                   ///< alpha of (2.1) [radian]
  double phase_offset = 0;            ///< phi, which shifts the arm phases and changes nothing else [radian]
  double period = 0;                  ///< T [time]
  double viscosity = 0;               ///< eta, dynamic [mass/(length time)]

  double angular_frequency() const;  ///< omega = 2 pi / T [radian/time]

  bool operator==(const CollinearSwimmer&) const = default;
};

/// Returns the collinear swimmer of `type` whose beads lie along the unit vector `axis`, in a fluid of
/// dynamic `viscosity` [mass/(length time)]. The angular spring is omitted, because it is relaxed in a
/// straight swimmer. Driving in frame `lab` acts along x, so the amplitudes change sign for axis -x.
///
/// Throws InputError if the driving frame is `lab` and the axis is not parallel to x: the beads would leave
/// the line. Throws InputError if a spring has no stiffness: the mean arm length would be undetermined.
CollinearSwimmer collinear_swimmer(const SwimmerType& type, const Vec3& axis, double viscosity);

/// Returns alpha = sqrt(i omega rho / eta) with Re alpha > 0, for a fluid of density rho = `fluid_density`
/// [1/length]. Vorticity decays like exp(-alpha x) with the distance x.
std::complex<double> inverse_penetration_depth(const CollinearSwimmer& swimmer, double fluid_density);

/// Returns the bead positions at rest, with bead 2 at the origin [length].
LinePositions rest_positions(const CollinearSwimmer& swimmer);

/// Returns the gaps of beads 1, 2 and of beads 2, 3 at rest [length]. A negative gap is an overlap.
std::array<double, 2> gaps_at_rest(const CollinearSwimmer& swimmer);

/// Returns the smaller of 2 l_i/(lambda_i + lambda_{i+1}). It equals l/lambda for equal beads and arms, and 2
/// for beads that touch.
double separation_ratio(const CollinearSwimmer& swimmer);

/// Returns the mobility of the beads at rest in open space, with the pair mobility `law` [time/mass].
CollinearMobility rest_mobility(const CollinearSwimmer& swimmer, PairLaw law);

}  // namespace beadswim
