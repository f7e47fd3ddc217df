#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Search for the least value of a function of a few numbers, each from 0 to 1, without derivatives. The same
// arguments give the same result.

namespace beadswim {

/// Position in the unit cube.
using Position = std::vector<double>;

/// Value of the function and violations of the constraints at one position.
struct Trial {
  std::optional<double> value;     ///< to be made small; nullopt: the function does not exist there
  std::vector<double> violations;  ///< violation of each inequality, relative to its bound; satisfied up to 0

  double max_violation() const;  ///< 0 if all constraints are satisfied
  bool is_feasible() const;      ///< the function exists, and all constraints are satisfied
};

using EvaluateTrial = std::function<Trial(const Position&)>;

struct SearchSettings {
  int num_inequalities = 0;
  int evaluations = 0;     ///< largest number
  unsigned long seed = 1;  ///< seed of the random numbers of the global search
};

struct SearchResult {
  Position best;
  Trial trial;                    ///< at `best`; not feasible if no feasible position was found
  int evaluations = 0;            ///< number of calls of `evaluate`
  bool has_converged = false;     ///< false: the evaluations were used up before
  std::string global{}, local{};  ///< names of the algorithms (nlopt.readthedocs.io)
};

/// Searches globally with six tenths of the evaluations and from the best position locally with the rest,
/// until positions change by less than 1e-5. Four numbers or more are searched in rounds of 100 evaluations
/// per number, each with other random numbers; the best result counts. Throws the exceptions of `evaluate`.
///
/// Global algorithm: DIRECT-L for up to three numbers, otherwise the controlled random search CRS2. Positions
/// that are not feasible are worse than all that are. Local algorithm: the quadratic models of BOBYQA; with
/// constraints or one number, the linear models of COBYLA; without constraints, where the global search has
/// met positions without a value, the simplex of Nelder and Mead.
SearchResult search(int dimensions, const EvaluateTrial& evaluate, const SearchSettings& settings);

/// Returns how far one coordinate can move down and up from the best position of a search, the others being
/// fixed, until the function has grown by `share` of its size, a constraint is violated or the cube ends. The
/// ends of the range are such positions, and at most 3 % of their distance from the best too near.
std::pair<double, double> flat_range(const SearchResult& found, int coordinate, double share,
                                     const EvaluateTrial& evaluate);

}  // namespace beadswim
