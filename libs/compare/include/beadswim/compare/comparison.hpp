#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/compare/swimming.hpp"
#include "beadswim/core/fields.hpp"

// Runs held against references, and the verdict.

namespace beadswim {

/// One swimmer of a run.
struct RunSwimmer {
  std::string source;  ///< the run's file
  int id = 0;
  Swimming swimming;  ///< knows all quantities
};

/// One method's answer for a swimmer: a prediction's method, or "run" for another run.
struct Reference {
  std::string source;  ///< the reference's file
  std::string method;
  bool usable = true;  ///< false: shown, never decides
  Swimming swimming;
};

struct Criterion {
  std::vector<ComparedQuantity> quantities;
  double tolerance = 0;      ///< largest |relative error| that passes
  std::size_t deciding = 0;  ///< position of the reference whose rows decide
};

struct ComparisonRow {
  ComparedQuantity quantity{};
  std::optional<int> arm;  ///< 1 or 2 for arm amplitudes
  std::string run_source;
  int swimmer = 0;
  std::string reference_source, method;
  bool usable = true;
  double run = 0, reference = 0;
  double relative_error = 0;
  double tolerance = 0;
  bool pass = false;
  bool decides = false;

  static void visit_fields(auto&& visit, auto& row) {
    visit("quantity", row.quantity);
    visit("arm", row.arm, omitted_if_none);
    visit("run_file", row.run_source);
    visit("swimmer", row.swimmer);
    visit("run", row.run);
    visit("reference_file", row.reference_source);
    visit("reference", row.reference);
    visit("method", row.method);
    visit("usable", row.usable);
    visit("relative_error", row.relative_error, null_if_infinite);
    visit("tolerance", row.tolerance);
    visit("pass", row.pass);
    visit("decides", row.decides);
  }
};

/// (run - reference)/|reference|; 0 if both are zero, infinite if the reference alone is.
double relative_error(double run, double reference);

/// Root of the mean square of values, of which there is one at least.
double root_mean_square(std::span<const double> values);

/// Position of the best usable reference that knows all quantities: inertia-corrected, else multipole-ode,
/// rpy-ode, rpy-perturbation, else the first; none if there is none.
std::optional<std::size_t> best_reference(std::span<const Reference> references,
                                          std::span<const ComparedQuantity> quantities);

/// A row for each number that the run and a reference both have: by quantity, arm, then reference.
/// Only rows of the deciding reference decide, and only if it is usable.
std::vector<ComparisonRow> compare_swimmer(const RunSwimmer& run, std::span<const Reference> references,
                                           const Criterion& criterion);

/// True if some row decides and all that decide pass.
bool verdict(std::span<const ComparisonRow> rows);

}  // namespace beadswim
