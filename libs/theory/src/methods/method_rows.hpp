#pragma once

#include <optional>
#include <string>

#include "beadswim/theory/methods.hpp"
#include "beadswim/theory/periodic_motion.hpp"

// The functions behind the rows of the table of methods.

namespace beadswim {

// Why a question cannot be treated.
std::optional<std::string> overlap_obstacle(const Question& question);
std::optional<std::string> exact_obstacle(const Question& question);
std::optional<std::string> equal_shape_obstacle(const Question& question);
std::optional<std::string> equal_parts_obstacle(const Question& question);
std::optional<std::string> rpy_force_printed_obstacle(const Question& question);
std::optional<std::string> oseen_stroke_obstacle(const Question& question);
std::optional<std::string> measured_stroke_obstacle(const Question& question);
std::optional<std::string> box_obstacle(const Question& question);
std::optional<std::string> inertia_obstacle(const Question& question);
std::optional<std::string> inertia_corrected_obstacle(const Question& question);

// The paper's formulas.
Prediction predict_oseen_force(const Question& question);
Prediction predict_oseen_stroke(const Question& question);
Prediction predict_oseen_ratio_printed(const Question& question);
Prediction predict_oseen_ratio_repaired(const Question& question);
Prediction predict_rpy_force_printed(const Question& question);
Prediction predict_rpy_force_repaired(const Question& question);
Prediction predict_rpy_stroke_printed(const Question& question);
Prediction predict_rpy_equal_weight(const Question& question);
Prediction predict_multipole_stroke(const Question& question);

// Second order in amplitude.
Prediction predict_oseen_perturbation(const Question& question);
Prediction predict_rpy_perturbation(const Question& question);
Prediction predict_multipole_perturbation(const Question& question);
Prediction predict_rpy_box_perturbation(const Question& question);

// Finite amplitude.
Prediction predict_oseen_ode(const Question& question);
Prediction predict_rpy_ode(const Question& question);
Prediction predict_multipole_ode(const Question& question);
Prediction predict_rpy_box_ode(const Question& question);

// With inertia of fluid and beads.
Prediction predict_unsteady_response(const Question& question);
Prediction predict_inertia_corrected(const Question& question);

/// Nearest that beads may come for the exact mobility, surface to surface [length].
double least_exact_gap(const CollinearSwimmer& swimmer);

/// The periodic motion by exact mobilities in open space. Throws InputError as `periodic_motion` does.
PeriodicMotion exact_periodic_motion(const CollinearSwimmer& swimmer);

}  // namespace beadswim
