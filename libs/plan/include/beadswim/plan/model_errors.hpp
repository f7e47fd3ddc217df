#pragma once

#include <optional>
#include <string>

#include "beadswim/compare/run_uncertainty.hpp"
#include "beadswim/coupling/bead_scheme.hpp"
#include "beadswim/mobility/mobility_model.hpp"
#include "beadswim/overdamped/overdamped_setup.hpp"
#include "beadswim/plan/lattice_lag.hpp"
#include "beadswim/theory/question.hpp"

// Relative errors of a swimmer's velocity and arm amplitudes that are expected in a run, for each model. They
// are estimated before the run, from theory and from measured errors of lattice runs. Page:
// docs/method/expected-errors.md.

namespace beadswim {

/// Converts relative errors.
inline ErrorEstimate estimate_of(const MotionValues& errors) {
  return {.velocity = errors[0], .arm_amplitudes = {errors[1], errors[2]}};
}

/// Expected relative error of a run: its usual size and its limit.
struct ErrorRange {
  /// Root mean square of the error over similar scenes and places within cells.
  MotionValues typical = MotionValues::Zero();
  MotionValues limit = MotionValues::Zero();  ///< 95 of 100 runs have a smaller error

  /// Adds a known contribution to the errors of the velocity.
  void add_to_velocity(double contribution) {
    typical[0] += contribution;
    limit[0] += contribution;
  }
};

/// Expected errors of a run of a scene: the largest of all its swimmers.
struct RunErrors {
  ExpectedErrors limits;
  ErrorEstimate typical;  ///< as ErrorRange::typical
};

/// Motion by the most accurate method of theory (inertia-corrected), and its uncertainty.
struct BestPrediction {
  MotionValues motion = MotionValues::Zero();
  MotionValues uncertainty = MotionValues::Zero();  ///< relative
  /// Factor by which errors of lattice runs increase because contributions to the velocity cancel. It is the
  /// velocity of the same stroke in open space without inertia, divided by `velocity()`, times (1 +
  /// uncertainty of the velocity), but at least 1.
  double cancellation = 1;
  bool is_swimming = true;         ///< false: the velocity is zero or only roundoff, without a relative error
  double smallest_stroke_gap = 0;  ///< smallest gap of neighbouring beads in the stroke [length]

  double velocity() const { return motion[0]; }
};

/// Returns the prediction of the method inertia-corrected, which includes the inertia of fluid and beads.
/// Throws InputError if the method cannot treat the question, for example because beads touch or overlap.
BestPrediction best_prediction(const Question& question);

/// Returns the relative differences of a motion from `best`; 0 for a velocity or arm amplitude of `best` that
/// is zero.
MotionValues difference(const MotionValues& motion, const BestPrediction& best);

/// Returns the relative error of the velocity in a run with a mobility model by its time steps and by the
/// accuracy of the products of mobility and forces.
double velocity_error_of_steps(MobilityModel model, const MobilitySettings& settings);

/// Returns the expected relative error of a run with a mobility model. The limit is the sum of 1.15 times the
/// relative difference between the model and `best`, the uncertainty of `best` and, for the velocity, the
/// errors by the time step and by the tolerance of mobility products. The typical error contains the
/// difference once, and half of the uncertainty as an independent error. The model unsteady is more accurate
/// than `best`; its error follows from its approximations alone. Throws InputError if beads touch, because no
/// periodic motion exists then.
ErrorRange mobility_error(const Question& question, const BestPrediction& best, MobilityModel model,
                          const MobilitySettings& settings);

/// Properties of a run with the model lbm that determine its error.
struct ResolvedRun {
  double cells_per_radius = 0;  ///< cells per radius of the smallest bead
  BeadScheme scheme = BeadScheme::mr;
  double smallest_gap = 0;  ///< smallest gap at rest of beads, images and walls [cell]
  double cell = 0;          ///< edge of a cell [length]
  double mach = 0;          ///< Mach number of the fastest bead
  double plane_factor = 1;  ///< lattice_plane_factor(), the largest of all swimmers
  LatticeTiming timing;
};

/// Returns the factor, from 1 to 5, by which the velocity wanders more because the beads of a swimmer are on
/// planes of the lattice: 1 + 4 cos^2(2 pi y) cos^2(2 pi z), where y and z [cell] are the coordinates across
/// the swimmer. Returns 1 for a swimmer that is not parallel to an axis of the lattice. `position`: of
/// bead 2 [cell].
double lattice_plane_factor(const Vec3& position, const Vec3& axis);

/// Returns the relative errors of a run with the model lbm by time steps and cells of finite size. The error
/// of time steps follows from theory (`lag`), and the error of cells from measurements. If `best` is nullopt,
/// the estimate assumes that beads touch during the stroke.
ErrorRange resolution_error(const LatticeLag& lag, const std::optional<BestPrediction>& best,
                            const ResolvedRun& run);

/// Returns the relative errors of a run with the model lbm by the place of the beads within cells: the
/// velocity of a cycle wanders while the swimmer moves through a cell. The limit is two standard deviations.
ErrorRange wander_error(const std::optional<BestPrediction>& best, const ResolvedRun& run);

/// Return the root of the sum of squares of two independent errors.
MotionValues combined(const MotionValues& a, const MotionValues& b);
ErrorRange combined(const ErrorRange& a, const ErrorRange& b);

}  // namespace beadswim
