#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/plan/model_errors.hpp"
#include "beadswim/plan/representatives.hpp"
#include "beadswim/plan/run_plan.hpp"

// Properties of a scene that a plan needs for all models.

namespace beadswim {

/// A representative swimmer, with the results of theory for it that do not depend on the model of the run.
struct SwimmerFacts {
  Representative representative;
  std::optional<BestPrediction> best;  ///< nullopt: theory finds no periodic motion
  std::string obstacle;                ///< reason why `best` or `lag` is nullopt
  std::optional<LatticeLag> lag;       ///< errors by time steps; nullopt: theory cannot evaluate them
  double tilt_growth = 1;              ///< factor by which a tilt grows in half a period (growth_of_tilt)
};

/// A scene and the results of theory for its swimmers.
struct SceneFacts {
  Layout cell;            ///< smallest cell whose repetition gives the scene
  Index3 cells{1, 1, 1};  ///< number of repetitions along x, y, z
  std::vector<SwimmerFacts> swimmer_facts;
  double disorder_growth = 1;  ///< factor by which deviations from the order of the swarm grow in the run
};

/// Returns the facts of a layout for a run of `cycles` base cycles.
SceneFacts scene_facts(const Layout& layout, double cycles);

/// Returns a message if theory finds no periodic motion for the swimmer. Returns a message, too, if beads
/// come so close during the stroke that no mobility model is accurate in the thin film between them.
/// Otherwise returns an empty string.
std::string film_obstacle(const SwimmerFacts& swimmer_facts);

/// Returns the larger of `a` and `b` for each quantity.
ErrorEstimate componentwise_max(const ErrorEstimate& a, const ErrorEstimate& b);

/// Returns all errors, multiplied by `factor`.
ErrorEstimate scaled(double factor, ErrorEstimate error);

/// Factor of the error estimate if the prediction for a swimmer was made for simplified neighbours, a
/// simplified box or a simplified driving.
constexpr double approximation_factor = 2;

/// Returns the largest expected errors of the swimmers that represent the scene. Each error is multiplied by
/// the factor for approximations, by the growth of an initial tilt during the run and by the growth of
/// disorder. `error_of` returns the ErrorEstimate for one SwimmerFacts.
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

/// Return the candidates with the model lbm and with mobility models, with their errors and costs.
/// Collective.
std::vector<PlannedRun> lattice_runs(const Layout& layout, const SceneFacts& facts,
                                     const PlanRequest& request, const std::string& source,
                                     const Communicator& communicator);
std::vector<PlannedRun> mobility_runs(const Layout& layout, const SceneFacts& facts,
                                      const PlanRequest& request, const std::string& source,
                                      const Communicator& communicator);

}  // namespace beadswim
