#pragma once

#include <optional>
#include <string>

#include "beadswim/theory/methods.hpp"

// The functions behind the rows of the table of methods.

namespace beadswim {

std::optional<std::string> perturbation_obstacle(const Question& question);
Prediction predict_oseen_perturbation(const Question& question);
Prediction predict_rpy_perturbation(const Question& question);

std::optional<std::string> oseen_force_obstacle(const Question& question);
Prediction predict_oseen_force(const Question& question);

std::optional<std::string> oseen_stroke_obstacle(const Question& question);
Prediction predict_oseen_stroke(const Question& question);

}  // namespace beadswim
