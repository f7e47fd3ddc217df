#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/plan/model_errors.hpp"
#include "beadswim/plan/representatives.hpp"
#include "beadswim/plan/run_plan.hpp"

// Properties of a scene that a plan needs for all models.

namespace beadswim {

/// A representative swimmer, with all results of theory that do not depend on the model of the run.
struct SwimmerFacts {
  Representative representative;
  std::optional<BestPrediction> best;  ///< nullopt: theory has no motion for it
  std::string obstacle;                ///< reason if `best` is nullopt
  std::optional<LatticeLag> lag;       ///< nullopt: theory cannot evaluate the lag
  double tilt_growth = 1;              ///< largest factor by which a tilt grows within a period
};

/// The scene as theory sees it.
struct SceneFacts {
  Layout cell;            ///< smallest cell that the scene repeats
  Index3 cells{1, 1, 1};  ///< repetitions of the cell along x, y, z
  std::vector<SwimmerFacts> swimmer_facts;
  double disorder_growth = 1;  ///< factor by which deviations from the order of the swarm grow in the run
};

/// Returns the facts of a layout for a run of `cycles` base cycles.
SceneFacts scene_facts(const Layout& layout, double cycles);

/// Returns a message if theory has no motion for the swimmer, or if beads come so close in their stroke that
/// no mobility model is accurate in the thin film between them. Returns an empty string otherwise.
std::string film_obstacle(const SwimmerFacts& swimmer_facts);

/// Returns the larger of each error.
ErrorEstimate componentwise_max(const ErrorEstimate& a, const ErrorEstimate& b);

/// Returns all errors, multiplied by `factor`.
ErrorEstimate scaled(double factor, ErrorEstimate error);

/// Factor of the error estimate if neighbours, walls or the driving of a slanted swimmer are approximated.
constexpr double approximation_factor = 2;

/// Returns the largest errors of all representatives, with the factors for approximations, tilt and disorder.
/// `error_of` returns the ErrorEstimate of one SwimmerFacts.
template <class ErrorOf>
ErrorEstimate scene_error(const SceneFacts& facts, const ErrorOf& error_of) {
  ErrorEstimate error;
  for (const SwimmerFacts& swimmer_facts : facts.swimmer_facts) {
    const double factor = (swimmer_facts.representative.approximation.empty() ? 1 : approximation_factor) *
                          (swimmer_facts.representative.is_slanted ? swimmer_facts.tilt_growth : 1);
    error = componentwise_max(error, scaled(factor, error_of(swimmer_facts)));
  }
  error.velocity *= facts.disorder_growth;
  return error;
}

/// Start-up cost per rank [core-seconds] and memory of the program per rank without a scene [byte], measured
/// in short runs.
constexpr double start_seconds = 0.05, program_bytes = 3.5e7;

/// Returns the disk space of the trajectory, the flow fields and the checkpoints [byte]. `bytes_per_cell`:
/// state of one lattice cell [byte].
double output_bytes(const RunSettings& settings, std::size_t swimmers, double cells, double bytes_per_cell);

/// Return the candidates with the lattice and with mobility models, with their errors and costs. Collective.
std::vector<PlannedRun> lattice_runs(const Layout& layout, const SceneFacts& facts,
                                     const PlanRequest& request, const std::string& source,
                                     const Communicator& communicator);
std::vector<PlannedRun> mobility_runs(const Layout& layout, const SceneFacts& facts,
                                      const PlanRequest& request, const std::string& source,
                                      const Communicator& communicator);

}  // namespace beadswim
