#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/coupling/scene_on_lattice.hpp"
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
  UnitScales units;       ///< natural_units() of the scene, those of all quantities here
  Layout cell;            ///< smallest cell whose repetition gives the scene
  Index3 cells{1, 1, 1};  ///< number of repetitions along x, y, z
  std::vector<SwimmerFacts> swimmer_facts;
  MotionValues box_changes = MotionValues::Zero();  ///< ExpectedErrors::box
  std::string unvalidated;     ///< name of a type for which errors have not been validated; empty if none
  double disorder_growth = 1;  ///< factor by which deviations from the order of the swarm grow in the run
  /// Smallest height of a bead over the wall of a half-space at rest [radius].
  double height = std::numeric_limits<double>::infinity();
};

/// Returns the facts of a layout for a run of `cycles` base cycles.
SceneFacts scene_facts(const Layout& layout, double cycles);

/// Returns the reason why no mobility model is accurate for the swimmer: theory finds no periodic motion, or
/// three beads on a line come so close during the stroke that the thin film between them matters. Otherwise
/// returns an empty string.
std::string film_obstacle(const SwimmerFacts& swimmer_facts);

/// Returns true if the prediction for the representative is for a simplified scene or another shape.
inline bool is_simplified(const Representative& representative) {
  return representative.is_stand_in || !representative.approximation.empty();
}

/// Factor that multiplies the limit of an error if its prediction was made for simplified neighbours, a
/// simplified box or a simplified driving of the swimmer. docs/results/simplified-scenes.sh measured how many
/// errors are within their limits with this factor and without it.
constexpr double approximation_factor = 2;

/// Returns the largest expected errors of the swimmers that represent the scene. `error_of` returns the
/// ErrorRange for one SwimmerFacts. `is_predicted`: this error follows from a prediction of the motion. If
/// the prediction is for a simplified scene, both arms get the larger limit, and limits are multiplied by
/// approximation_factor. If forces act at an angle to the axis, all errors are multiplied by the growth of a
/// tilt in half a period. The error of the velocity is always multiplied by the growth of disorder in the
/// run.
template <class ErrorOf>
ErrorRange scene_error(const SceneFacts& facts, const ErrorOf& error_of, bool is_predicted = true) {
  ErrorRange largest;
  for (const SwimmerFacts& swimmer_facts : facts.swimmer_facts) {
    const bool is_slanted = is_predicted && swimmer_facts.representative.is_slanted;
    const double growth = is_slanted ? swimmer_facts.tilt_growth : 1;
    const ErrorRange error = error_of(swimmer_facts);
    MotionValues limit = growth * error.limit;
    if (is_predicted && is_simplified(swimmer_facts.representative)) {
      limit *= approximation_factor;
      limit.tail<2>().setConstant(limit.tail<2>().maxCoeff());
    }
    largest.typical = largest.typical.max(growth * error.typical);
    largest.limit = largest.limit.max(limit);
  }
  largest.typical[0] *= facts.disorder_growth;
  largest.limit[0] *= facts.disorder_growth;
  return largest;
}

/// Layout and request of a plan, with the facts of the layout. `source`: name of the layout in messages.
struct PlanInput {
  const Layout& layout;
  const SceneFacts& facts;
  const PlanRequest& request;
  const std::string& source;
  const Communicator& communicator;
};

/// Adds the start of the program on `ranks` ranks to cost and memory of a candidate, which are those of its
/// scene, and sets its disk space. `cells`: cells of a lattice, whose state the memory is.
void complete_cost(PlannedRun& run, std::size_t beads, double cells, int ranks);

/// Returns the expected errors of a lattice run of the scene. `roundoff`: relative error of the velocity by
/// roundoff, which the errors by resolution include. Throws InputError if theory cannot evaluate errors of a
/// swimmer.
RunErrors lattice_run_errors(const SceneOnLattice& on_lattice, const SceneFacts& facts, double roundoff);

/// Returns the expected errors of a run with a mobility model. Throws InputError if theory cannot predict the
/// motion of a swimmer, or if no mobility model is accurate for the scene.
RunErrors mobility_run_errors(const SceneFacts& facts, MobilityModel model, const MobilitySettings& settings);

/// Returns a text with the usual numbers of cells per radius that lattice_runs() leaves out because they do
/// not fit the box, or an empty string.
std::string left_out_resolutions(const Layout& layout);

/// Return the candidates (possible runs) with the model lbm and with mobility models, with their expected
/// errors and costs. Collective.
std::vector<PlannedRun> lattice_runs(const PlanInput& input);
std::vector<PlannedRun> mobility_runs(const PlanInput& input);

}  // namespace beadswim
