#include "beadswim/compare/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "beadswim/swimmers/swimmer_shape.hpp"

namespace beadswim {
namespace {

/// Methods in order of preference. The first method is closest to a resolved run.
constexpr std::array preferred_methods{"inertia-corrected", "multipole-ode", "rpy-ode", "rpy-perturbation"};

/// Returns 0 for the most preferred method and larger values for others. All methods that are not in the list
/// have the same, largest value.
std::ptrdiff_t preference(const Reference& reference) {
  return std::ranges::find(preferred_methods, reference.method) - preferred_methods.begin();
}

bool is_angle(ResultQuantity quantity) {
  return row_of(quantity).dimension == Dimension::angle;
}

bool is_phase(ResultQuantity quantity) {
  return is_angle(quantity) || quantity == ResultQuantity::sin_phase_shift;
}

/// Returns the size up to which a value of a reference is a numerical error: by roundoff of bead positions,
/// by the accuracy of bead velocities (1e-10 of MotionScale::speed), or as the reference states. The error of
/// a phase is that of the smaller of two arm amplitudes, divided by this amplitude.
double zero_threshold(const MotionScale& scale, const Reference& reference, ResultQuantity quantity) {
  constexpr double roundoff = 1e-12, accuracy = 1e-10;  // relative to length and to speed
  const double speed =
      std::max({accuracy * scale.speed, roundoff * scale.length / scale.period, reference.numerical_error});
  if (!is_phase(quantity)) return scale.size_of(quantity, speed);
  double amplitude = std::numeric_limits<double>::infinity();
  for (const std::size_t arm : {0UL, 1UL})
    amplitude = std::min(
        amplitude, number_of(reference.results, ResultQuantity::arm_amplitudes, arm).value_or(amplitude));
  return std::max(accuracy, scale.size_of(ResultQuantity::arm_amplitudes, speed) / amplitude);
}

/// Sets the numbers of a row for number i of a quantity. Returns the difference of run and reference: for
/// vectors its size, with the sign of run - reference along the reference, for angles within half a turn.
double set_numbers(const RunSwimmer& run, const Reference& reference, std::size_t i, ComparisonRow& row) {
  const ResultValue &value = run.results.at(row.quantity), &other = reference.results.at(row.quantity);
  row.run = value.numbers[i];
  row.reference = other.numbers[i];
  row.run_uncertainty = value.uncertainty(i);
  row.reference_uncertainty = other.uncertainty(i);
  const double difference = row.run - row.reference;
  auto vector = value.vector;
  const auto& expected = other.vector;
  if (!vector || !expected)
    return is_angle(row.quantity) ? std::remainder(difference, 2 * std::numbers::pi) : difference;
  if (run.axis && reference.axis) vector = shortest_turn(*run.axis, *reference.axis) * *vector;
  const Vec3 along = (row.reference < 0 ? -1 : 1) * (expected->isZero(0) ? *vector : *expected).normalized();
  row.run = vector->dot(along);
  row.reference = expected->dot(along);
  return std::copysign((*vector - *expected).norm(), row.run - row.reference);
}

/// Makes the error and the uncertainties of a row, whose reference is zero or an angle, relative to `scale`.
void make_relative_to(double scale, double difference, ComparisonRow& row) {
  row.relative_error = relative_error(difference, scale);
  if (scale > 0 && row.run_uncertainty) *row.run_uncertainty *= std::abs(row.run) / scale;
  if (scale > 0 && row.reference_uncertainty) *row.reference_uncertainty *= std::abs(row.reference) / scale;
}

/// Returns the row for number i of a quantity. If it has one number per arm, i + 1 is the number of the arm.
ComparisonRow compare_number(const RunSwimmer& run, const Reference& reference, ResultQuantity quantity,
                             std::size_t i, double tolerance) {
  ComparisonRow row{.quantity = quantity,
                    .run_file = run.source,
                    .swimmer = run.id,
                    .reference_file = reference.source,
                    .method = reference.method,
                    .usable = reference.usable,
                    .tolerance = tolerance};
  if (row_of(quantity).is_per_arm) row.arm = static_cast<int>(i) + 1;
  const double difference = set_numbers(run, reference, i, row);
  row.relative_error = relative_error(difference, row.reference);
  const double zero = zero_threshold(run.scale, reference, quantity);
  double scale = std::abs(row.reference);
  if (scale <= zero || is_angle(quantity)) {
    scale = run.scale.size_of(quantity, run.scale.speed);
    make_relative_to(scale, std::abs(difference) <= zero ? 0 : difference, row);
  }
  // Means with thermal noise agree within two standard errors of their difference.
  const auto standard_error = [&](const ResultValue& value) { return value.is_mean ? value.error(i) : 0; };
  const double error =
      std::hypot(standard_error(run.results.at(quantity)), standard_error(reference.results.at(quantity)));
  if (scale > 0) row.tolerance = std::max(tolerance, 2 * error / scale);
  row.pass = std::abs(row.relative_error) <= row.tolerance;  // false for NaN
  return row;
}

}  // namespace

double MotionScale::size_of(ResultQuantity quantity, double bead_speed) const {
  switch (row_of(quantity).dimension) {
    case Dimension::velocity:
      return bead_speed;
    case Dimension::length:
      return bead_speed * period / (2 * std::numbers::pi);
    case Dimension::angular_velocity:
      return length > 0 ? bead_speed / length : 0;
    case Dimension::angle:
      return 1;
    case Dimension::number:
    case Dimension::power:
    case Dimension::energy:
    case Dimension::diffusion:
    case Dimension::rate:
      break;
  }
  return quantity == ResultQuantity::sin_phase_shift ? 1 : 0;
}

double relative_error(double difference, double reference) {
  if (difference == 0) return 0;
  if (reference == 0) return std::copysign(std::numeric_limits<double>::infinity(), difference);
  return difference / std::abs(reference);
}

double root_mean_square(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

std::optional<std::size_t> best_reference(std::span<const Reference> references,
                                          std::span<const ResultQuantity> quantities) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < references.size(); ++i) {
    const auto is_known = [&](ResultQuantity quantity) { return references[i].results.contains(quantity); };
    if (references[i].usable && std::ranges::all_of(quantities, is_known) &&
        (!best || preference(references[i]) < preference(references[*best])))
      best = i;
  }
  return best;
}

std::vector<ComparisonRow> compare_swimmer(const RunSwimmer& run, std::span<const Reference> references,
                                           const Criterion& criterion) {
  std::vector<ComparisonRow> rows;
  const auto compare = [&](ResultQuantity quantity, std::size_t i) {
    for (std::size_t r = 0; r < references.size(); ++r) {
      if (!number_of(references[r].results, quantity, i)) continue;
      if (is_phase(quantity) && zero_threshold(run.scale, references[r], quantity) >= 1) continue;
      rows.push_back(compare_number(run, references[r], quantity, i, criterion.tolerance));
      rows.back().decides = references[r].usable && r == criterion.deciding;
    }
  };
  for (const ResultQuantity quantity : criterion.quantities)
    for (std::size_t i = 0; i < count_numbers(run.results, quantity); ++i) compare(quantity, i);
  return rows;
}

bool verdict(std::span<const ComparisonRow> rows) {
  return std::ranges::any_of(rows, &ComparisonRow::decides) &&
         std::ranges::all_of(rows, [](const ComparisonRow& row) { return !row.decides || row.pass; });
}

}  // namespace beadswim
