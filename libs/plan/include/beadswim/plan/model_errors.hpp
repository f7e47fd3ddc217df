#pragma once

#include <array>
#include <optional>
#include <string>

#include "beadswim/core/fields.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/mobility/mobility_model.hpp"
#include "beadswim/plan/lattice_lag.hpp"
#include "beadswim/theory/question.hpp"

// Expected errors of a run with each model, before it is made: relative errors of a swimmer's velocity and
// arm amplitudes, estimated by theory and by measured errors of the lattice. Page:
// docs/method/expected-errors.md.

namespace beadswim {

/// Expected relative errors of velocity and arm amplitudes.
struct ErrorEstimate {
  double velocity = 0;
  std::array<double, 2> arm_amplitudes{};

  double largest() const;  ///< maximum of all errors

  static void visit_fields(auto&& visit, auto& error) {
    visit("velocity", error.velocity, omitted_if_zero);  // zero if nothing swims
    visit("arm_amplitudes", error.arm_amplitudes);
  }
};

/// Velocity and arm amplitudes by the most accurate method of theory, with their uncertainty.
struct BestPrediction {
  double velocity = 0;                     ///< [length/time]
  std::array<double, 2> arm_amplitudes{};  ///< [length]
  ErrorEstimate uncertainty;
  /// Measure of the cancellation of contributions to the velocity: the velocity of the same stroke in open
  /// space without inertia, divided by the velocity, times (1 + uncertainty of the velocity). At least 1.
  double cancellation = 1;
  bool is_swimming = true;  ///< false: the velocity is zero by symmetry, so a relative error is undefined
  double smallest_stroke_gap = 0;  ///< smallest gap of neighbouring beads in the stroke [length]
};

/// Returns the prediction of the method inertia-corrected. Throws InputError if the method cannot treat the
/// question, for example because beads touch or overlap.
BestPrediction best_prediction(const Question& question);

/// Returns the expected error of a run with a mobility model: the difference from `best`, the uncertainty of
/// `best`, and the error of the time steps. Throws InputError if the model has no periodic motion because
/// beads touch.
ErrorEstimate mobility_error(const Question& question, const BestPrediction& best, MobilityModel model,
                             int steps_per_cycle);

/// Resolution of a scene on a lattice.
struct ResolvedRun {
  double cells_per_radius = 0;  ///< cells per radius of the smallest bead
  BeadScheme scheme = BeadScheme::mr;
  double smallest_gap = 0;  ///< smallest gap at rest of beads, images and walls [cell]
  double cell = 0;          ///< edge of a cell [length]
  double mach = 0;          ///< Mach number of the fastest bead
  LatticeTiming timing;
};

/// Returns the expected error of a resolved run: the error of the time steps by theory and the error of the
/// cells by measurement. If `best` is not known, the estimate assumes that beads touch in their stroke.
ErrorEstimate lattice_error(const LatticeLag& lag, const std::optional<BestPrediction>& best,
                            const ResolvedRun& run);

}  // namespace beadswim
