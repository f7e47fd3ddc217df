#include "beadswim/study/search.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <nlopt.hpp>

namespace beadswim {
namespace {

constexpr double position_tolerance = 1e-5;      // change of positions at which the local search ends
constexpr double barrier = 1e6;                  // above all values of feasible positions, which are about 1
constexpr double undefined_value = 2 * barrier;  // where the function does not exist
constexpr double global_share = 0.6;             // share of the evaluations for the global search
constexpr int round_share = 100;                 // evaluations per number in a round of the search
/// Distance from the limits of constraints at which the local search aims. Its linear models are wrong by
/// less, so that its positions satisfy the constraints.
constexpr double margin = 1e-6;

bool is_better(const Trial& trial, const Trial& than) {
  if (trial.is_feasible() != than.is_feasible()) return trial.is_feasible();
  if (trial.is_feasible()) return *trial.value < *than.value;
  if (trial.value.has_value() != than.value.has_value()) return trial.value.has_value();
  return trial.max_violation() < than.max_violation();
}

/// Evaluates each position once and keeps the best. NLopt replaces exceptions of its functions by its own, so
/// the first one is kept for rethrow().
class Trials {
 public:
  explicit Trials(const EvaluateTrial& evaluate) : evaluate_(evaluate) {}

  const Trial& at(const Position& position) {
    const auto known = trials_.find(position);
    if (known != trials_.end()) return known->second;
    const Trial& trial = trials_.emplace(position, evaluated(position)).first->second;
    if (scale_ == 0 && trial.value) scale_ = std::abs(*trial.value);
    if (result_.best.empty() || is_better(trial, result_.trial)) {
      result_.best = position;
      result_.trial = trial;
    }
    met_undefined_ = met_undefined_ || !trial.value;
    ++result_.evaluations;
    return trial;
  }

  /// The value of a trial in units of the first one, for algorithms whose numbers are about 1.
  double scaled(const Trial& trial) const { return scale_ > 0 ? *trial.value / scale_ : *trial.value; }

  const SearchResult& result() const { return result_; }
  /// Returns whether there were positions without a value.
  bool has_met_undefined() const { return met_undefined_; }
  /// Throws the exception of an evaluation, if there was one.
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  Trial evaluated(const Position& position) {
    try {
      return evaluate_(position);
    } catch (...) {
      exception_ = std::current_exception();
      throw nlopt::forced_stop();
    }
  }

  const EvaluateTrial& evaluate_;
  std::exception_ptr exception_;
  std::map<Position, Trial> trials_;
  double scale_ = 0;
  bool met_undefined_ = false;
  SearchResult result_;
};

double value_with_barrier(const Trials& trials, const Trial& trial) {
  if (!trial.value) return undefined_value;
  if (!trial.is_feasible()) return barrier * (1 + std::min(trial.max_violation(), 0.5));
  return std::min(trials.scaled(trial), barrier);
}

/// An algorithm of NLopt with its name.
struct Algorithm {
  nlopt::algorithm id;
  const char* name;
};

Algorithm global_algorithm(int dimensions) {
  if (dimensions <= 3) return {nlopt::GN_DIRECT_L, "DIRECT-L"};
  return {nlopt::GN_CRS2_LM, "CRS2"};
}

Algorithm local_algorithm(int dimensions, int num_inequalities, bool has_met_undefined) {
  if (num_inequalities > 0) return {nlopt::LN_COBYLA, "COBYLA"};
  if (has_met_undefined) return {nlopt::LN_NELDERMEAD, "Nelder-Mead"};
  if (dimensions == 1) return {nlopt::LN_COBYLA, "COBYLA"};  // BOBYQA needs two
  return {nlopt::LN_BOBYQA, "BOBYQA"};
}

/// Returns the algorithm for the unit cube. It minimises the value with the barrier.
nlopt::opt algorithm_for(const Algorithm& algorithm, int dimensions, int evaluations, Trials& trials) {
  nlopt::opt made(algorithm.id, static_cast<unsigned>(dimensions));
  made.set_lower_bounds(0.0);
  made.set_upper_bounds(1.0);
  made.set_maxeval(evaluations);
  const nlopt::vfunc value = [](const Position& position, Position&, void* data) {
    auto& all = *static_cast<Trials*>(data);
    return value_with_barrier(all, all.at(position));
  };
  made.set_min_objective(value, &trials);
  return made;
}

/// Calls the algorithm. Returns true if it ended before its evaluations were used up.
bool optimise(nlopt::opt& algorithm, Position start, const Trials& trials) {
  double least = 0;
  try {
    return algorithm.optimize(start, least) != nlopt::MAXEVAL_REACHED;
  } catch (const nlopt::roundoff_limited&) {
    return true;  // the result is as good as rounding errors allow
  } catch (const std::exception&) {
    trials.rethrow();
    throw;
  }
}

/// Constraint of a local search, for the interface of NLopt.
struct LocalConstraint {
  Trials& trials;
  std::size_t index;
};

/// Lets the algorithm treat the constraints as such, in place of the barrier.
void add_constraints(nlopt::opt& algorithm, std::vector<LocalConstraint>& constraints, Trials& trials) {
  const nlopt::vfunc value = [](const Position& position, Position&, void* data) {
    auto& all = *static_cast<Trials*>(data);
    const Trial& trial = all.at(position);
    return trial.value ? all.scaled(trial) : all.scaled(all.result().trial) + 1;
  };
  const nlopt::vfunc violation = [](const Position& position, Position&, void* data) {
    const auto& constraint = *static_cast<LocalConstraint*>(data);
    const Trial& trial = constraint.trials.at(position);
    return trial.value ? trial.violations[constraint.index] + margin : 1;
  };
  algorithm.set_min_objective(value, &trials);
  for (LocalConstraint& constraint : constraints)
    algorithm.add_inequality_constraint(violation, &constraint, 0);
}

/// Searches globally and then, from the best position, locally.
SearchResult search_once(int dimensions, const EvaluateTrial& evaluate, int num_inequalities,
                         int evaluations) {
  constexpr double first_step = 0.05;
  Trials trials(evaluate);
  const Algorithm global = global_algorithm(dimensions);
  nlopt::opt globally =
      algorithm_for(global, dimensions, static_cast<int>(std::lround(global_share * evaluations)), trials);
  optimise(globally, Position(static_cast<std::size_t>(dimensions), 0.5), trials);

  const int left = evaluations - trials.result().evaluations;
  const Algorithm local = local_algorithm(dimensions, num_inequalities, trials.has_met_undefined());
  bool has_converged = false;
  if (left > 0 && trials.result().trial.value) {
    nlopt::opt locally = algorithm_for(local, dimensions, left, trials);
    std::vector<LocalConstraint> all;
    for (int c = 0; c < num_inequalities; ++c) all.push_back({trials, static_cast<std::size_t>(c)});
    if (num_inequalities > 0) add_constraints(locally, all, trials);
    locally.set_initial_step(first_step);
    locally.set_xtol_abs(position_tolerance);
    has_converged = optimise(locally, trials.result().best, trials);
  }
  SearchResult found = trials.result();
  found.has_converged = has_converged;
  found.global = global.name;
  found.local = local.name;
  return found;
}

}  // namespace

double Trial::max_violation() const {
  double largest = 0;
  for (const double each : violations) largest = std::max(largest, each);
  return largest;
}

bool Trial::is_feasible() const {
  return value && max_violation() <= 0;
}

SearchResult search(int dimensions, const EvaluateTrial& evaluate, const SearchSettings& settings) {
  nlopt::srand(settings.seed);
  const int rounds = dimensions <= 3 ? 1 : std::max(1, settings.evaluations / (round_share * dimensions));
  SearchResult found;
  for (int round = 0; round < rounds; ++round) {
    const SearchResult next =
        search_once(dimensions, evaluate, settings.num_inequalities, settings.evaluations / rounds);
    const int evaluations = found.evaluations + next.evaluations;
    if (round == 0 || is_better(next.trial, found.trial)) found = next;
    found.evaluations = evaluations;
  }
  return found;
}

std::pair<double, double> flat_range(const SearchResult& found, int coordinate, double share,
                                     const EvaluateTrial& evaluate) {
  const auto axis = static_cast<std::size_t>(coordinate);
  const double best = found.best[axis], limit = *found.trial.value + share * std::abs(*found.trial.value);
  const auto is_flat_at = [&](double place) {
    Position position = found.best;
    position[axis] = place;
    const Trial trial = evaluate(position);
    return trial.is_feasible() && *trial.value <= limit;
  };
  const auto end_towards = [&](double bound) {
    const double room = bound - best;
    double inside = 0, outside = 0x1p-9;  // parts of the room
    if (room == 0) return bound;
    while (outside < 1 && is_flat_at(best + outside * room)) inside = std::exchange(outside, 2 * outside);
    if (outside >= 1 && is_flat_at(bound)) return bound;
    outside = std::min(outside, 1.0);
    while (outside - inside > 0.03 * outside) {
      const double middle = (inside + outside) / 2;
      (is_flat_at(best + middle * room) ? inside : outside) = middle;
      if (outside < 0x1p-14) break;  // the optimum is at the limit of a constraint
    }
    return best + inside * room;
  };
  return {end_towards(0), end_towards(1)};
}

}  // namespace beadswim
