#pragma once

#include <optional>
#include <string>

#include "beadswim/theory/methods.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "beadswim/theory/unsteady_multipole.hpp"

// Functions in the rows of the table of methods (methods.cpp).

namespace beadswim {

/// Steady mobility of beads in open space, in the forms that methods need.
struct BeadMobility {
  const char* name;  ///< in predictions
  CollinearMobility (*on_line)(const CollinearSwimmer& swimmer, const LinePositions& positions);
  PairTensorLaw tensors;  ///< for swimmers of any shape; nullptr: not a sum over pairs
};
extern const BeadMobility oseen_beads, rotne_prager_beads, exact_beads;

// Each function returns the reason why a method cannot treat the question; nullopt if it can treat it.
std::optional<std::string> overlap_obstacle(const Question& question);
std::optional<std::string> exact_obstacle(const Question& question);
std::optional<std::string> box_obstacle(const Question& question);
std::optional<std::string> inertia_obstacle(const Question& question);
std::optional<std::string> unsteady_multipole_obstacle(const Question& question);
std::optional<std::string> inertia_corrected_obstacle(const Question& question);

/// Returns the methods by closed formulas, most of them from the paper (closed_forms.hpp).
std::vector<Method> closed_form_methods();

// Predictions to second order in amplitude, and at finite amplitude by the periodic motion.
Prediction predict_perturbation(const BeadMobility& mobility, const Question& question);
Prediction predict_rpy_box_perturbation(const Question& question);
Prediction predict_ode(const BeadMobility& mobility, const Question& question);
Prediction predict_rpy_box_ode(const Question& question);

// Predictions for swimmers of any shape.
Prediction predict_shape_perturbation(const BeadMobility& mobility, const ShapeQuestion& question);
Prediction predict_shape_ode(const BeadMobility& mobility, const ShapeQuestion& question);

// Predictions with inertia of fluid and beads.
Prediction predict_unsteady_response(const Question& question);
Prediction predict_unsteady_multipole(const Question& question);
Prediction predict_inertia_corrected(const Question& question);

/// Returns the exact motion of the swimmer with inertia. Requires that unsteady_multipole_obstacle() returns
/// nullopt.
ExactInertia exact_inertia(const Question& question);

/// Returns the uncertainty of the velocity of a motion with inertia because the amplitude is finite
/// [length/time]. The change `by_amplitude` is that of exact Stokes flow; its uncertainty is the share of
/// inertia in the velocity. The contributions of inertia change with the amplitude by the larger of
/// (d_i/l_i)^2 and the Reynolds number U^2/(omega nu).
double amplitude_uncertainty(const Question& question, const ExactMotion& motion, double by_amplitude);

/// Returns the gap of neighbouring beads down to which exact_mobility() is used in a periodic motion
/// [length].
double min_exact_gap(const CollinearSwimmer& swimmer);

/// Returns the periodic motion with exact mobilities in open space. Throws the errors of periodic_motion().
PeriodicMotion exact_periodic_motion(const CollinearSwimmer& swimmer);

// Return the results in `question` (with_open_space_motion()), or compute them.
inline ExactInertia inertia_of(const Question& question) {
  return question.inertia ? *question.inertia : exact_inertia(question);
}
inline PeriodicMotion finite_motion(const Question& question) {
  return question.finite ? *question.finite : exact_periodic_motion(question.swimmer);
}

}  // namespace beadswim
