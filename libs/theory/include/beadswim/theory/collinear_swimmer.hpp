#pragma once

#include <array>
#include <complex>
#include <optional>

#include "beadswim/collinear/collinear_mobility.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {

/// A swimmer whose beads stay on a line, with all parameters that theory needs, in any coherent units.
/// Coordinates, forces and velocities are positive from bead 1 towards bead 3. By equation (2.1) of Pickl et
/// al. 2017, the driving forces are A sin(omega t) on bead 1, B sin(omega t + alpha) on bead 3 and minus
/// their sum on bead 2.
struct CollinearSwimmer {
  std::array<double, 3> radius{};     ///< lambda_i of beads 1, 2, 3 [length]
  std::array<double, 3> density{};    ///< bead density [mass/length^3]; used only with inertia
  std::array<double, 2> arm{};        ///< rest lengths l_i [length]
  std::array<double, 2> stiffness{};  ///< k_i of the springs [mass/time^2]
  std::array<double, 2> damping{};    ///< c_i of the dashpots [mass/time]
  std::array<double, 2> amplitude{};  ///< driving amplitudes A, B along the axis [mass length/time^2]
  double phase = 0;                   ///< driving phase alpha: bead 3 ahead of bead 1 [radian]
  double phase_offset = 0;            ///< phi, which is added to the phases of both arms [radian]
  double period = 0;                  ///< period T of the driving [time]
  double viscosity = 0;               ///< eta, dynamic [mass/(length time)]

  double angular_frequency() const;  ///< omega = 2 pi / T [radian/time]

  bool operator==(const CollinearSwimmer&) const = default;
};

/// Returns true if the beads of a three-bead swimmer along `axis` stay on a line: the driving forces act
/// along its axis. Driving in the frame `lab` acts along x.
bool stays_on_a_line(const ThreeBeadSwimmer& type, const Vec3& axis);

/// Returns the collinear swimmer of `type` whose beads lie along the unit vector `axis`, in a fluid of
/// dynamic `viscosity` [mass/(length time)]. The angular spring is omitted, because it exerts no force in a
/// straight swimmer. Driving in the frame `lab` acts along x, so the amplitudes change sign if the axis is
/// -x.
///
/// Throws InputError if the driving frame is `lab` and the axis is not parallel to x: the beads would leave
/// the line. Throws InputError if a spring has no stiffness: the mean arm length would be undetermined.
CollinearSwimmer collinear_swimmer(const ThreeBeadSwimmer& type, const Vec3& axis, double viscosity);

/// Returns the collinear swimmer of a type, driven along its own axis; nullopt if the type has no
/// three_bead_form(). Throws InputError if a spring has no stiffness.
std::optional<CollinearSwimmer> collinear_swimmer(const SwimmerType& type, double viscosity);

/// Returns alpha = sqrt(i omega rho/eta) with Re alpha > 0 [1/length], where rho is `fluid_density`, and
/// omega and eta are the angular frequency and the dynamic viscosity of `swimmer`. Vorticity decays as
/// exp(-alpha x) with the distance x. This alpha is not the driving phase.
std::complex<double> inverse_penetration_depth(const CollinearSwimmer& swimmer, double fluid_density);

/// Returns the mass of a sphere [mass], from its radius [length] and density [mass/length^3].
double sphere_mass(double radius, double density);

/// Returns the bead positions at rest, with bead 2 at the origin [length].
LinePositions rest_positions(const CollinearSwimmer& swimmer);

/// Returns the gaps of beads 1, 2 and of beads 2, 3 at rest [length]. A negative gap is an overlap.
std::array<double, 2> gaps_at_rest(const CollinearSwimmer& swimmer);

/// Returns the smaller of the two ratios 2 l_i/(lambda_i + lambda_{i+1}), where l_i is the rest length of arm
/// i and lambda_i the radius of bead i. The ratio is l/lambda for equal beads and equal arms, and 2 for beads
/// that touch.
double separation_ratio(const CollinearSwimmer& swimmer);

/// Returns the mobility matrix of the three beads at their positions at rest in open space, with the pair
/// mobility `law`, and its derivatives by the positions [time/mass, time/(mass length)].
CollinearMobility rest_mobility(const CollinearSwimmer& swimmer, PairLaw law);

}  // namespace beadswim
