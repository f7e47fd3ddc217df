#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/plan/model_errors.hpp"
#include "beadswim/plan/representatives.hpp"
#include "beadswim/plan/run_plan.hpp"

// What a plan knows of a scene, whatever runs it.

namespace beadswim {

/// A representative with all that does not depend on how it is run.
struct Asked {
  Representative representative;
  std::optional<BestKnown> best;  ///< none: theory has no motion for it
  std::string why_not;            ///< if there is none
  std::optional<LatticeLag> lag;  ///< none: nor for what steps do to it
  double turning = 1;             ///< by which a tilt can grow while driving presses it together
};

struct SceneFacts {
  Layout cell;  ///< smallest cell
  Index3 cells{1, 1, 1};
  std::vector<Asked> asked;
  double disorder = 1;  ///< by which departures of swimmers from their order grow in the run
};

/// What a plan asks of a layout, for a run of `cycles`.
SceneFacts facts_of(const Layout& layout, double cycles);

/// That beads come so near in their stroke that the film between them matters, which no mobility model has
/// well; empty if they do not.
std::string film_between_beads(const Asked& asked);

ErrorEstimate worst(const ErrorEstimate& a, const ErrorEstimate& b);  ///< the larger of each error
ErrorEstimate times(double factor, ErrorEstimate error);

/// Times the estimate where neighbours, walls or slant are approximated.
constexpr double rough = 2;

/// `error_of` every representative, and the worst of it for the scene.
template <class ErrorOf>
ErrorEstimate scene_error(const SceneFacts& facts, const ErrorOf& error_of) {
  ErrorEstimate error;
  for (const Asked& asked : facts.asked) {
    const double factor = (asked.representative.approximation.empty() ? 1 : rough) *
                          (asked.representative.is_slanted ? asked.turning : 1);
    error = worst(error, times(factor, error_of(asked)));
  }
  error.velocity *= facts.disorder;
  return error;
}

/// Core-seconds of a rank before the first step, and what it takes without a scene [byte], as short runs have
/// them.
constexpr double start_seconds = 0.05, program_bytes = 3.5e7;

/// Of trajectory, flow and checkpoints; `bytes_of_cell`: of a lattice's state.
double output_bytes(const RunSettings& settings, std::size_t swimmers, double cells, double bytes_of_cell);

/// Runs by the lattice and by mobility models, with errors and costs. Collective.
std::vector<PlannedRun> lattice_runs(const Layout& layout, const SceneFacts& facts,
                                     const PlanRequest& request, const std::string& source,
                                     const Communicator& communicator);
std::vector<PlannedRun> mobility_runs(const Layout& layout, const SceneFacts& facts,
                                      const PlanRequest& request, const std::string& source,
                                      const Communicator& communicator);

}  // namespace beadswim
