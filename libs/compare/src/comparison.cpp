#include "beadswim/compare/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace beadswim {
namespace {

/// Methods in order of preference. The first method is closest to a resolved run.
constexpr std::array preferred_methods{"inertia-corrected", "multipole-ode", "rpy-ode", "rpy-perturbation"};

/// Returns 0 for the most preferred method and larger values for others. All methods that are not in the list
/// have the same, largest value.
std::ptrdiff_t preference(const std::string& method) {
  return std::find(preferred_methods.begin(), preferred_methods.end(), method) - preferred_methods.begin();
}

bool can_decide(const Reference& reference, std::span<const ComparedQuantity> quantities) {
  return reference.usable &&
         std::all_of(quantities.begin(), quantities.end(),
                     [&](ComparedQuantity quantity) { return reference.swimming.contains(quantity); });
}

/// Returns a row with quantity, sources and method, but without the compared numbers.
ComparisonRow labelled_row(const RunSwimmer& run, const Reference& reference, ComparedQuantity quantity) {
  ComparisonRow row;
  row.quantity = quantity;
  row.run_source = run.source;
  row.swimmer = run.id;
  row.reference_source = reference.source;
  row.method = reference.method;
  row.usable = reference.usable;
  return row;
}

std::optional<double> value_of(const ComparedValues& values, ComparedQuantity quantity, std::size_t i) {
  const auto found = values.find(quantity);
  if (found == values.end() || i >= found->second.size()) return std::nullopt;
  return found->second[i];
}

/// Returns the row for number i of a quantity. Arm amplitudes have one number per arm, and i + 1 is the
/// number of the arm. Other quantities have one number.
ComparisonRow compare_number(const RunSwimmer& run, const Reference& reference, ComparedQuantity quantity,
                             std::size_t i, double tolerance) {
  ComparisonRow row = labelled_row(run, reference, quantity);
  if (quantity == ComparedQuantity::arm_amplitudes) row.arm = static_cast<int>(i) + 1;
  row.run = run.swimming.at(quantity)[i];
  row.reference = reference.swimming.at(quantity)[i];
  row.relative_error = relative_error(row.run, row.reference);
  row.run_uncertainty = value_of(run.uncertainties, quantity, i);
  row.reference_uncertainty = value_of(reference.uncertainties, quantity, i);
  row.tolerance = tolerance;
  row.pass = std::abs(row.relative_error) <= tolerance;  // false for NaN
  return row;
}

}  // namespace

double relative_error(double run, double reference) {
  if (run == reference) return 0;
  if (reference == 0) return std::copysign(std::numeric_limits<double>::infinity(), run);
  return (run - reference) / std::abs(reference);
}

double root_mean_square(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

std::optional<std::size_t> best_reference(std::span<const Reference> references,
                                          std::span<const ComparedQuantity> quantities) {
  std::optional<std::size_t> best;
  std::ptrdiff_t best_rank = 0;
  for (std::size_t i = 0; i < references.size(); ++i) {
    if (!can_decide(references[i], quantities)) continue;
    const std::ptrdiff_t rank = preference(references[i].method);
    if (best && rank >= best_rank) continue;
    best = i;
    best_rank = rank;
  }
  return best;
}

std::vector<ComparisonRow> compare_swimmer(const RunSwimmer& run, std::span<const Reference> references,
                                           const Criterion& criterion) {
  std::vector<ComparisonRow> rows;
  const auto compare = [&](ComparedQuantity quantity, std::size_t i) {
    for (std::size_t r = 0; r < references.size(); ++r) {
      if (!value_of(references[r].swimming, quantity, i)) continue;
      rows.push_back(compare_number(run, references[r], quantity, i, criterion.tolerance));
      rows.back().decides = references[r].usable && r == criterion.deciding;
    }
  };
  for (const ComparedQuantity quantity : criterion.quantities) {
    const auto numbers = run.swimming.find(quantity);
    if (numbers == run.swimming.end()) continue;
    for (std::size_t i = 0; i < numbers->second.size(); ++i) compare(quantity, i);
  }
  return rows;
}

bool verdict(std::span<const ComparisonRow> rows) {
  const auto decides = [](const ComparisonRow& row) { return row.decides; };
  return std::any_of(rows.begin(), rows.end(), decides) &&
         std::all_of(rows.begin(), rows.end(),
                     [](const ComparisonRow& row) { return !row.decides || row.pass; });
}

}  // namespace beadswim
