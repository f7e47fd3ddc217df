#include "verdict_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace beadswim {
namespace {

std::string quantity_text(const ComparisonRow& row) {
  switch (row.quantity) {
    case ComparedQuantity::velocity:
      return "velocity";
    case ComparedQuantity::arm_amplitudes:
      return fmt::format("arm amplitude d{}", row.arm.value());
    case ComparedQuantity::sin_phase_shift:
      return "sin(delta1 - delta2)";
    case ComparedQuantity::angular_velocity:
      return "angular velocity";
  }
  return {};
}

/// Returns the text of a row's verdict. It is in brackets if the row does not affect the verdict of the whole
/// comparison.
std::string verdict_text(const ComparisonRow& row) {
  if (!row.usable) return "(unusable)";
  if (row.decides) return row.pass ? "pass" : "FAIL";
  return row.pass ? "(pass)" : "(fail)";
}

std::string error_text(const ComparisonRow& row) {
  if (!std::isfinite(row.relative_error)) return "-";
  constexpr double largest_shown = 1000;  // larger errors belong to a reference that is zero but for roundoff
  if (std::abs(row.relative_error) > largest_shown) return "> 100000 %";
  const double percent = std::round(1e4 * row.relative_error) / 100;
  return fmt::format("{:+.2f} %", percent == 0 ? 0.0 : percent);  // avoids "-0.00"
}

/// Returns the uncertainty of the error: the root of the sum of squares of those of run and reference that
/// are known.
std::string uncertainty_text(const ComparisonRow& row) {
  if (!row.run_uncertainty && !row.reference_uncertainty) return "";
  const double uncertainty =
      std::hypot(row.run_uncertainty.value_or(0), row.reference_uncertainty.value_or(0));
  return uncertainty < 0.1 ? fmt::format("± {:.2g} %", 100 * uncertainty)
                           : fmt::format("± {:.0f} %", 100 * uncertainty);
}

/// Returns true if a heading must precede row i of the table. This is true for the first row of each run and
/// swimmer if the table contains several runs or swimmers.
bool begins_section(std::span<const ComparisonRow> rows, std::size_t i) {
  const auto other = [&](const ComparisonRow& row) {
    return row.run_source != rows[i].run_source || row.swimmer != rows[i].swimmer;
  };
  return std::any_of(rows.begin(), rows.end(), other) && (i == 0 || other(rows[i - 1]));
}

}  // namespace

std::string verdict_table(const VerdictDocument& document) {
  constexpr auto line = "{:<21} {:>13} {:>13}  {:<22} {:>10} {:>9}  {}\n";
  std::string table = fmt::format(line, "quantity", "run", "reference", "method", "error", "", "verdict");
  for (std::size_t i = 0; i < document.rows.size(); ++i) {
    const ComparisonRow& row = document.rows[i];
    if (begins_section(document.rows, i))
      table += fmt::format("{}, swimmer {}:\n", row.run_source, row.swimmer);
    table += fmt::format(line, quantity_text(row), fmt::format("{:.5g}", row.run),
                         fmt::format("{:.5g}", row.reference), row.method, error_text(row),
                         uncertainty_text(row), verdict_text(row));
  }
  for (const auto& [property, run, reference] : document.scene_differences)
    table += fmt::format("allowed difference: {}: run {}, reference {}\n", to_text(property), run, reference);
  const bool pass = verdict(document.rows);
  return table + fmt::format("verdict: {}, decided by {}, tolerance {:g} %\n", pass ? "pass" : "FAIL",
                             document.decided_by, 100 * document.rows.front().tolerance);
}

}  // namespace beadswim
