#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/collinear/collinear_mobility.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/scene/unit_scales.hpp"
#include "beadswim/theory/collinear_swimmer.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "beadswim/theory/perturbation.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "beadswim/theory/stroke.hpp"
#include "beadswim/theory/unsteady_multipole.hpp"

namespace beadswim {

/// Position of a swimmer in a box.
struct BoxPlace {
  Box box;                              ///< first axis parallel to the swimmer
  std::array<double, 3> middle_bead{};  ///< position of bead 2 at rest, from the corner of the box [length]
};

/// Motion of the swimmer in exact Stokes flow of its three beads in open space: the reference for the errors
/// of all methods.
struct ExactStokes {
  CollinearMobility mobility;   ///< mobility of the beads at rest
  PeriodicMotion motion;        ///< motion to second order in the driving amplitude
  double amplitude_change = 0;  ///< estimated relative change of the swimmer's velocity at finite amplitude
};

/// Exact motion with inertia in unbounded fluid, and the flow from which it follows.
struct ExactInertia {
  UnsteadyMultipoles flow;
  ExactMotion motion;
  double numerical_error = 0;  ///< change of the velocity from a coarser resolution [length/time]
};

/// Input of methods that treat swimmers of any shape, alone in open space.
struct ShapeQuestion {
  ShapedSwimmer swimmer;
  double fluid_density = 0;  ///< rho [mass/length^3]
  UnitScales units{};        ///< of the question, in the units of the layout, for texts
};

/// Input of all methods for three beads on a line: a swimmer, its fluid, its box (or open space), and its
/// stroke if it was measured.
struct Question {
  CollinearSwimmer swimmer;
  double fluid_density = 0;     ///< rho [mass/length^3]
  std::optional<BoxPlace> box{};  ///< nullopt: open space, or methods for boxes are not applicable
  std::string box_obstacle{};     ///< reason why methods for boxes are not applicable; empty if none
  std::optional<Stroke> measured_stroke{};
  std::optional<ExactStokes> exact{};  ///< set by with_exact_reference(); nullopt if not available
  /// Motion in open space with inertia, and at finite amplitude without; set by with_open_space_motion().
  std::optional<ExactInertia> inertia{};
  std::optional<PeriodicMotion> finite{};
  UnitScales units{};                ///< of the question, in the units of the layout, for texts
};

/// Returns the mobility of the beads at `positions` [length] in exact Stokes flow in open space [time/mass].
/// `tolerance`: relative error of the mobility at which the multipole series is truncated.
CollinearMobility exact_mobility(const CollinearSwimmer& swimmer, const LinePositions& positions,
                                 double tolerance = 1e-12);

/// Returns the question with `exact` set to the motion in exact Stokes flow. `exact` stays nullopt if beads
/// touch or nearly touch, because the multipole series would then need too many terms.
Question with_exact_reference(Question question);

/// Returns the question with `inertia` and `finite` set, for questions that differ only in their boxes and
/// for several methods. Each stays nullopt if it cannot be computed; methods that need it then throw the
/// reason.
Question with_open_space_motion(Question question);

/// Returns warnings that concern all methods. They report beads that touch during the stroke, and driving so
/// strong that the relative error of second-order methods exceeds `tolerance`.
std::vector<std::string> warnings(const Question& question, double tolerance);

}  // namespace beadswim
