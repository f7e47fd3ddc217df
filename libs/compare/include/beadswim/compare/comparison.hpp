#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/compare/result_quantity.hpp"
#include "beadswim/core/fields.hpp"

// Comparison of runs with references (predictions or other runs), and the verdict: whether a run agrees with
// the reference within the tolerance.

namespace beadswim {

/// Quantities that are compared unless others are chosen.
inline constexpr std::array default_quantities{ResultQuantity::velocity, ResultQuantity::arm_amplitudes,
                                               ResultQuantity::sin_phase_shift};

/// Scales of a swimmer's motion, to which the errors of quantities that should be zero are relative.
struct MotionScale {
  double period = 1;           ///< [time]
  double length = 0;           ///< longest mean arm, or radius of the largest bead [length]
  double speed = 0;            ///< largest speed of a bead [length/time]
  double numerical_error = 0;  ///< error of velocities; 0 if none is stated [length/time]

  /// Returns the scale of a quantity for beads of this speed: their displacement in one radian of the drives
  /// for lengths, bead_speed/length for angular velocities, 1 for angles and sines, 0 (none) for others.
  double size_of(ResultQuantity quantity, double bead_speed) const;
};

/// One swimmer of a run.
struct RunSwimmer {
  std::string source;  ///< file of the run
  int id = 0;
  Results results;
  MotionScale scale = {};
  std::optional<Vec3> axis = {};  ///< direction in the box; vectors are compared in the swimmer's own axes
};

/// Quantities of one swimmer that a run is compared with.
struct Reference {
  std::string source;  ///< file of the reference
  std::string method;  ///< method of a prediction, or "run" for another run
  bool usable = true;  ///< false: the comparison is shown but does not affect the verdict
  Results results;
  double numerical_error = 0;  ///< error of velocities; 0 if the source states none [length/time]
  /// Direction of the swimmer in the box; nullopt: vectors are compared in axes of the box
  std::optional<Vec3> axis = {};
};

/// Quantities, tolerance and reference that determine the verdict.
struct Criterion {
  std::vector<ResultQuantity> quantities;
  double tolerance = 0;      ///< largest accepted |relative error|
  std::size_t deciding = 0;  ///< index, in the list of references, of the one that determines the verdict
};

/// Comparison of one number of a run with the corresponding number of a reference.
struct ComparisonRow {
  ResultQuantity quantity{};
  std::optional<int> arm{};  ///< number of the arm, from 1, for quantities of arms; otherwise empty
  std::string run_file;
  int swimmer = 0;
  std::string reference_file, method;
  bool usable = true;
  double run = 0, reference = 0;
  double relative_error = 0;
  std::optional<double> run_uncertainty{}, reference_uncertainty{};  ///< relative; nullopt: unknown
  double tolerance = 0;  ///< accepted; of means with thermal noise at least two standard errors
  bool pass = false;
  bool decides = false;

  BEADSWIM_FIELDS(quantity, (arm, omitted_if_none), run_file, swimmer, run, reference_file, reference, method,
                  usable, (relative_error, null_if_infinite), run_uncertainty, reference_uncertainty,
                  tolerance, pass, decides)
};

/// Returns difference/|reference|. Returns 0 if both numbers are zero, and infinity with the sign of
/// `difference` if only the reference is zero.
double relative_error(double difference, double reference);

/// Returns the root mean square of `values`. There must be at least one value.
double root_mean_square(std::span<const double> values);

/// Returns the index in `references` of the best reference that is usable and contains all quantities;
/// nullopt if there is none. The order of preference of the methods is inertia-corrected, multipole-ode,
/// rpy-ode, rpy-perturbation, then all others. Among references of equal preference, the first is returned.
std::optional<std::size_t> best_reference(std::span<const Reference> references,
                                          std::span<const ResultQuantity> quantities);

/// Returns one row per number that both the run and a reference contain, ordered by quantity, arm and
/// reference. Vectors that both contain are compared as vectors, those of the run after the
/// shortest rotation of its axis onto that of the reference: the numbers of the row are the components
/// along the vector of the reference, and the error is that of the whole vector. If the reference is zero
/// within its numerical error, errors are relative to RunSwimmer::scale. The errors of angles are in radian.
/// Phases of arms without amplitude have no row. The verdict depends on the rows with decides == true: the
/// rows of the reference with the index Criterion::deciding, if this reference is usable.
std::vector<ComparisonRow> compare_swimmer(const RunSwimmer& run, std::span<const Reference> references,
                                           const Criterion& criterion);

/// Returns true if at least one row has decides == true, and if pass == true in all of these rows.
bool verdict(std::span<const ComparisonRow> rows);

}  // namespace beadswim
