#pragma once

#include <string>

#include "beadswim/plan/model_errors.hpp"
#include "beadswim/plan/run_settings.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Relative errors that are expected in a run, by cause: the largest of all its swimmers.
struct ExpectedErrors {
  ErrorEstimate total;       ///< difference from the motion of the scene at infinite resolution
  ErrorEstimate resolution;  ///< by cells and time steps, or by the accuracy of mobility products
  ErrorEstimate wander;      ///< by the place of the beads within cells; 0 without a lattice
  ErrorEstimate box;         ///< not an error: change by walls and images, compared with open space
};

/// Returns the expected errors of a run of the layout. `settings`: model and resolution of the run. `source`:
/// name of the layout in messages. Throws InputError with the reason if they are not known.
ExpectedErrors expected_errors(const Layout& layout, const RunSettings& settings, const std::string& source);

}  // namespace beadswim
