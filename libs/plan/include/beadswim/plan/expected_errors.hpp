#pragma once

#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/plan/model_errors.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// Limits of the relative errors that are expected in a run, by cause: the largest of all its swimmers.
struct ExpectedErrors {
  ErrorEstimate total;       ///< difference from the motion of the scene at infinite resolution
  ErrorEstimate resolution;  ///< by cells and time steps, or by the accuracy of mobility products
  ErrorEstimate wander;      ///< by the place of the beads within cells; 0 without a lattice
  ErrorEstimate box;         ///< not an error: change by walls and images, compared with open space
};

/// Return the expected errors of a run of the layout for `cycles` base cycles: with a mobility model, or on
/// the lattice on which put_on_lattice() has put the layout. Throw InputError with the reason if the errors
/// are not known.
ExpectedErrors expected_errors(const Layout& layout, MobilityModel model, const MobilitySettings& settings,
                               double cycles);
ExpectedErrors expected_errors(const Layout& layout, const SceneOnLattice& on_lattice, double cycles);

/// Returns the relative error of the mobility of one sphere over a plane no-slip wall, at this height over
/// its radius: across the wall, where it is largest, and along it with rpy+near. A part of the expected
/// error.
double error_near_wall(double height, MobilityModel model, const MobilitySettings& settings);

}  // namespace beadswim
