#pragma once

#include <limits>
#include <string>
#include <vector>

#include "beadswim/study/quantity.hpp"
#include "evaluation.hpp"
#include "search.hpp"

// Optimisation problem: free values with their bounds, the objective, and constraints.

namespace beadswim {

constexpr const char* free_flag = "--free";

/// A value of the layout that the search may change, of one or several quantities. Positive bounds that
/// differ by a factor of ten or more are searched on a logarithmic scale.
struct FreeValue {
  std::vector<std::string> names;  ///< as quantity_name() returns them
  double from = 0, to = 0;

  bool is_logarithmic() const;
  /// Returns the value at a coordinate from 0 to 1.
  double at(double coordinate) const;
};

/// Parses NAME=FROM:TO, or NAME,NAME,...=FROM:TO for quantities with equal values, with FROM < TO for each
/// text. Throws InputError, also if a name occurs twice.
std::vector<FreeValue> parse_free_values(const std::vector<std::string>& texts);

/// Returns the values at a position in the unit cube.
StudyPoint study_point(const std::vector<FreeValue>& free, const Position& position);

/// Names of the quantities that have one number.
std::vector<std::string> outcome_names();

/// Range that an outcome must not leave.
struct Constraint {
  ResultQuantity outcome{};
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

/// Parses NAME=:MAX, NAME=MIN: or NAME=MIN:MAX. Throws InputError, also if a name occurs twice.
std::vector<Constraint> parse_constraints(const std::vector<std::string>& texts);

/// Objective, which is to be large or small, and constraints.
struct Problem {
  ResultQuantity objective{};
  bool is_maximised = true;
  std::vector<Constraint> constraints;

  /// Returns the number of inequalities: one per finite end of the range of a constraint.
  int num_inequalities() const;
  /// Returns the trial of outcomes, which must contain the objective and all limited ones. `typical`:
  /// outcomes whose sizes are the units of violations of a bound of 0.
  Trial trial_of(const Outcomes& outcomes, const Outcomes& typical) const;
  /// Throws InputError if the outcomes lack the objective or a limited one. `evaluator`: name of the method
  /// or model.
  void require_outcomes(const Outcomes& outcomes, const std::string& evaluator) const;

  /// Returns the outcomes that the trace and messages state: usual_outcomes and those of the problem.
  std::vector<ResultQuantity> stated_outcomes() const;

  const char* flag() const { return is_maximised ? "--maximise" : "--minimise"; }
};

}  // namespace beadswim
