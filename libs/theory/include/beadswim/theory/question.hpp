#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/mobility/collinear_mobility.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/perturbation.hpp"
#include "beadswim/theory/stroke.hpp"

namespace beadswim {

/// Where in which box a swimmer lies.
struct BoxPlace {
  Box box;                              ///< its first axis is the swimmer's
  std::array<double, 3> middle_bead{};  ///< bead 2 at rest, from the box's corner [length]
};

/// The three-sphere solution of Stokes flow in open space, which all methods state their errors against.
struct ExactStokes {
  CollinearMobility mobility;   ///< at rest
  SecondOrderMotion motion;     ///< to second order in amplitude
  double amplitude_change = 0;  ///< estimated relative change of the velocity at finite amplitude
};

/// What a method is asked: a swimmer, its surroundings, and the stroke that it was measured to have, if any.
struct Question {
  CollinearSwimmer swimmer;
  double fluid_density = 0;     ///< rho [mass/length^3]
  std::optional<BoxPlace> box;  ///< none: unbounded, or `box_obstacle` says why not
  std::string box_obstacle;     ///< why methods for boxes cannot treat its surroundings; empty if they can
  std::optional<Stroke> measured_stroke;
  std::optional<ExactStokes> exact;  ///< by `with_exact_reference`; none where it cannot be had
};

/// The mobility of the swimmer's beads at these places in open space, numerically exact to `tolerance`.
CollinearMobility exact_mobility(const CollinearSwimmer& swimmer, const LinePositions& positions,
                                 double tolerance = 1e-12);

/// The question with the reference that all methods state their errors against; without it where beads
/// touch or all but touch.
Question with_exact_reference(Question question);

/// What a user must know before believing any method: beads that meet within the stroke, or a driving beyond
/// small amplitude (second order off by more than `tolerance`, relative).
std::vector<std::string> warnings(const Question& question, double tolerance);

}  // namespace beadswim
