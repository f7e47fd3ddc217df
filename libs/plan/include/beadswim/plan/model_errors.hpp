#pragma once

#include <array>
#include <optional>
#include <string>

#include "beadswim/core/fields.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/mobility/mobility_model.hpp"
#include "beadswim/plan/lattice_lag.hpp"
#include "beadswim/theory/question.hpp"

// How wrong a run of each model would be, before it is run: relative errors of a swimmer's velocity and of
// its arms' amplitudes, by what theory knows. Page: docs/method/expected-errors.md.

namespace beadswim {

struct ErrorEstimate {
  double velocity = 0;
  std::array<double, 2> arm_amplitudes{};

  double largest() const;

  static void visit_fields(auto&& visit, auto& error) {
    visit("velocity", error.velocity, omitted_if_zero);  // nothing swims
    visit("arm_amplitudes", error.arm_amplitudes);
  }
};

/// A swimmer's velocity and arms' amplitudes by the best theory, and what is unknown of them.
struct BestKnown {
  double velocity = 0;                     ///< [length/time]
  std::array<double, 2> arm_amplitudes{};  ///< [length]
  ErrorEstimate uncertainty;
  /// How far parts of the velocity cancel: what the same stroke would make in open space without inertia,
  /// over the velocity, times 1 + uncertainty of that; at least 1.
  double cancellation = 1;
  bool swims = true;   ///< false: the velocity is zero by symmetry, and has no relative error
  double nearest = 0;  ///< gap to which an arm's beads come in the stroke [length]
};

/// `inertia-corrected`. Throws InputError where theory has no answer: beads that meet, or overlap.
BestKnown best_known(const Question& question);

/// Of a run without inertia: its distance from the best theory, what that does not know, and what steps
/// leave. Throws InputError where the model's own motion is none, as beads meet.
ErrorEstimate mobility_error(const Question& question, const BestKnown& best, MobilityModel model,
                             int steps_per_cycle);

/// How a lattice resolves a scene.
struct ResolvedRun {
  double cells_per_radius = 0;  ///< of the smallest bead
  BeadScheme scheme = BeadScheme::mr;
  double smallest_gap = 0;  ///< that surfaces have at rest, of beads, images and walls [cell]
  double cell = 0;          ///< [length]
  double mach = 0;          ///< of the fastest bead
  LatticeTiming timing;
};

/// Of a resolved run: by lag of its steps, and by its cells, as measured. Without a best theory beads are
/// taken to touch in their stroke.
ErrorEstimate lattice_error(const LatticeLag& lag, const std::optional<BestKnown>& best,
                            const ResolvedRun& run);

}  // namespace beadswim
