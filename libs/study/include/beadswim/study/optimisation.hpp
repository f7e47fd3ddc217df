#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/io/document_stream.hpp"
#include "beadswim/study/evaluation.hpp"
#include "beadswim/study/quantity.hpp"
#include "beadswim/study/search.hpp"

// Search for the values of a few quantities of a layout, in given bounds, with which an outcome is largest or
// smallest while other outcomes stay in their limits.

namespace beadswim {

/// A value of the layout that the search may change, of one or several quantities. Positive bounds that
/// differ by a factor of ten or more are searched on a logarithmic scale.
struct FreeValue {
  std::vector<std::string> names;  ///< as quantity_name() returns them
  double from = 0, to = 0;

  bool is_logarithmic() const { return from > 0 && to >= 10 * from; }
  /// Returns the value at a coordinate from 0 to 1.
  double at(double coordinate) const;
};

/// Returns the values at a position in the unit cube.
StudyPoint study_point(const std::vector<FreeValue>& free, const Position& position);

/// Names of the quantities that have one number.
std::vector<std::string> outcome_names();

/// Range that an outcome must not leave.
struct Constraint {
  ResultQuantity outcome{};
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

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
  /// Returns the outcomes that the trace and messages state: usual ones and those of the problem.
  std::vector<ResultQuantity> stated_outcomes() const;
};

/// What is searched, and by what.
struct Optimisation {
  std::vector<FreeValue> free;
  Problem problem;
  Evaluator by;
  std::optional<Evaluator> verifier{};  ///< evaluates the layout that was found once more
  SearchSettings search;
  std::function<void(const std::string&)> message;  ///< takes findings: texts without full stop
  std::function<void(const Json&)> trace;           ///< takes a record of each evaluation
};

/// Throws InputError if a free quantity does not exist in the layout, or if no layout was found in the bounds
/// that is valid.
void require_searchable(const StreamMember& member, const Optimisation& optimisation);

/// The layout that was found. Its study has the values found with the ends of the ranges in which the
/// objective is at most 1 % worse, NAME_from and NAME_to (of the first name of a free value), and the
/// objective, also as OBJECTIVE_by_METHOD by the method that verified it.
struct Optimum {
  LayoutDocument layout;
  bool is_unverified = false;  ///< true: the verifier could not evaluate it
};

/// Searches the best values of one layout. The search begins with the layout as it is or, if that cannot be
/// evaluated, with others in the bounds. Throws InputError if none can be evaluated or gives the outcomes of
/// the problem, or if the verifier cannot treat the first that was evaluated; SolverError if no layout
/// satisfies the limits.
Optimum optimise(const StreamMember& member, const Optimisation& optimisation);

}  // namespace beadswim
