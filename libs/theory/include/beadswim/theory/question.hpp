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

/// Position of a swimmer in a box.
struct BoxPlace {
  Box box;                              ///< first axis parallel to the swimmer
  std::array<double, 3> middle_bead{};  ///< position of bead 2 at rest, from the corner of the box [length]
};

/// Exact Stokes flow of the three spheres in open space: the reference for the errors of all methods.
struct ExactStokes {
  CollinearMobility mobility;   ///< mobility at rest
  SecondOrderMotion motion;     ///< motion to second order in amplitude
  double amplitude_change = 0;  ///< estimated relative change of the velocity at finite amplitude
};

/// Input of all methods: a swimmer, its surroundings, and its measured stroke if there is one.
struct Question {
  CollinearSwimmer swimmer;
  double fluid_density = 0;     ///< rho [mass/length^3]
  std::optional<BoxPlace> box;  ///< nullopt: open space, or surroundings that `box_obstacle` explains
  std::string box_obstacle;     ///< why methods for boxes cannot treat the surroundings; empty if they can
  std::optional<Stroke> measured_stroke;
  std::optional<ExactStokes> exact;  ///< set by with_exact_reference(); nullopt if not available
};

/// Returns the exact mobility of the beads at `positions` in open space, to the relative error `tolerance`.
CollinearMobility exact_mobility(const CollinearSwimmer& swimmer, const LinePositions& positions,
                                 double tolerance = 1e-12);

/// Returns the question with `exact` set. `exact` stays nullopt if beads touch or nearly touch, because the
/// multipole series would need too many terms.
Question with_exact_reference(Question question);

/// Returns warnings that concern all methods: beads that touch within the stroke, and a driving so strong
/// that the relative error of second-order methods exceeds `tolerance`.
std::vector<std::string> warnings(const Question& question, double tolerance);

}  // namespace beadswim
