#pragma once

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
  /// The mobility of a swimmer of any shape. `swimmer` must outlive it.
  ShapeMobility (*of_shape)(const ShapedSwimmer& swimmer);
};
extern const BeadMobility oseen_beads, rotne_prager_beads, exact_beads;

// Each function returns the reason why a method cannot treat the question; an empty text if it can treat it.
std::string overlap_obstacle(const Question& question);
std::string image_overlap_obstacle(const Question& question);
std::string exact_obstacle(const Question& question);
std::string box_obstacle(const Question& question);
std::string inertia_obstacle(const Question& question);
std::string unsteady_multipole_obstacle(const Question& question);
std::string inertia_corrected_obstacle(const Question& question);

// The same for swimmers of another shape: of second-order methods, of force moments, and of methods for
// boxes.
std::string shape_perturbation_obstacle(const Question& question);
std::string shape_moments_obstacle(const Question& question);
std::string shape_box_obstacle(const Question& question);

/// Returns an empty text: the method treats every shape.
inline std::string no_obstacle(const Question&) {
  return {};
}

/// Returns the methods by closed formulas, most of them from the paper (closed_forms.hpp).
std::vector<Method> closed_form_methods();

// Predictions to second order in amplitude, and at finite amplitude by the periodic motion.
Prediction predict_perturbation(const BeadMobility& mobility, const Question& question);
Prediction predict_ode(const BeadMobility& mobility, const Question& question);
Prediction predict_box_perturbation(const BeadMobility& mobility, const Question& question);
Prediction predict_box_ode(const BeadMobility& mobility, const Question& question);

// Predictions for swimmers of any shape. `swimmer`: that of the question, in its box or without it.
Prediction predict_shape_perturbation(const BeadMobility& mobility, const ShapedSwimmer& swimmer,
                                      const Question& question);
Prediction predict_shape_ode(const BeadMobility& mobility, const ShapedSwimmer& swimmer,
                             const Question& question);

/// Returns the reference of Question::reference().
ShapeReference shape_reference(const ShapedSwimmer& swimmer);

/// Returns boundary and length of each axis of a box, such as "periodic 128, periodic 80, periodic 80".
std::string box_text(const Box& box, double unit);

// Predictions with inertia of fluid and beads.
Prediction predict_unsteady_response(const Question& question);
Prediction predict_unsteady_multipole(const Question& question);
Prediction predict_inertia_corrected(const Question& question);

/// Returns the exact motion of the swimmer with inertia. Throws InputError with the reason of
/// unsteady_multipole_obstacle().
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

}  // namespace beadswim
