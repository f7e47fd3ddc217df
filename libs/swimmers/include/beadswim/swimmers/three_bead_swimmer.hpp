#pragma once

#include <array>
#include <optional>

#include "beadswim/core/fields.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// The three-bead swimmer of the paper (Pickl et al. 2017, section 2): three beads in a line and two arms,
// driven by forces along the line. It is a shorthand for one kind of SwimmerType; closed forms and theory of
// collinear swimmers use it.

namespace beadswim {

/// Driving forces on beads 1, 2, 3, equation (2.1) of the paper:
///   F1 = A sin(w t + phi)
///   F2 = -(F1 + F3)
///   F3 = B sin(w t + alpha + phi)
/// t is the time and w the angular frequency. phi is 0 in the paper. Frame lab: along x, the direction of the
/// external field; initial_axis: along the axis at the start of the run; body: F1 along the first arm on
/// beads 1 and 2, F3 along the second arm on beads 3 and 2, so that total force and total torque vanish.
struct ThreeBeadDriving {
  std::array<double, 2> amplitude{};  ///< A on bead 1, B on bead 3 [mass length/time^2]
  double phase = 0;                   ///< alpha [radian]
  double period = 0;                  ///< T = 2 pi/w [time]
  DrivingFrame frame = DrivingFrame::lab;
  double phase_offset = 0;  ///< phi [radian]

  bool operator==(const ThreeBeadDriving&) const = default;

  BEADSWIM_FIELDS(amplitude, phase, period, frame, (phase_offset, omitted_if(0)))
};

/// Beads 1, 2, 3 in a line. springs[0] joins beads 1 and 2, and springs[1] joins beads 2 and 3.
struct ThreeBeadSwimmer {
  std::array<Bead, 3> beads{};
  std::array<Spring, 2> springs{};
  double angular_stiffness = 0;  ///< K_A of U = K_A theta^2/2, theta: angle between the arms [energy]
  ThreeBeadDriving driving;

  bool operator==(const ThreeBeadSwimmer&) const = default;

  BEADSWIM_FIELDS(beads, springs, angular_stiffness, driving)
};

/// Returns the drives of a driving (2.1): forces on beads 1, 3 and 2, or, in the frame body, the tensions F1
/// of the first and -F3 of the second bond.
Driving drives(const ThreeBeadDriving& driving);

/// Returns the type of a three-bead swimmer: its frame has bead 2 at the origin, and the axis from bead 1 to
/// bead 3 along x.
SwimmerType swimmer_type(const ThreeBeadSwimmer& swimmer);

/// Returns the driving or the three-bead swimmer of which drives() or swimmer_type() makes the argument, or
/// nothing if there is none.
std::optional<ThreeBeadDriving> three_bead_form(const Driving& driving);
std::optional<ThreeBeadSwimmer> three_bead_form(const SwimmerType& type);

/// Returns three_bead_form(type). Throws InputError if there is none.
ThreeBeadSwimmer three_beads(const SwimmerType& type);

}  // namespace beadswim
