#include "verdict_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "beadswim/documents/layout_document.hpp"

namespace beadswim {
namespace {

std::string quantity_text(const ComparisonRow& row) {
  const auto& [quantity, name, dimension, label, symbol, is_per_arm] = row_of(row.quantity);
  if (is_per_arm) return fmt::format("{} {}{}", label, symbol, row.arm.value_or(1));
  return std::string(symbol.empty() ? label : symbol);
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

constexpr auto legend =
    "error: run minus reference, relative to the reference, ± the uncertainty of both; verdicts in "
    "parentheses do not count\n";

using Rows = std::vector<const ComparisonRow*>;

/// The rows of one swimmer of one run.
struct Section {
  std::string run_file;
  int swimmer = 0;
  Rows rows{};
};

std::vector<Section> sections_of(std::span<const ComparisonRow> rows) {
  std::vector<Section> sections;
  for (const ComparisonRow& row : rows) {
    if (sections.empty() || sections.back().run_file != row.run_file ||
        sections.back().swimmer != row.swimmer)
      sections.push_back({row.run_file, row.swimmer});
    sections.back().rows.push_back(&row);
  }
  return sections;
}

/// Returns the largest size of the relative errors for which is_counted(row).
double largest_error(const Rows& rows, auto&& is_counted) {
  double largest = 0;
  for (const ComparisonRow* row : rows)
    if (is_counted(*row)) largest = std::max(largest, std::abs(row->relative_error));
  return largest;
}

/// Returns the usable methods of a section with the smallest of their largest errors.
std::vector<std::string> best_methods(const Rows& rows, std::size_t count) {
  std::map<std::string, double> errors;
  for (const ComparisonRow* row : rows) {
    if (!row->usable || row->decides) continue;
    errors[row->method] =
        largest_error(rows, [row](const ComparisonRow& other) { return other.method == row->method; });
  }
  std::vector<std::string> methods;
  for (const auto& [method, error] : errors) methods.push_back(method);
  std::ranges::stable_sort(methods, {}, [&](const std::string& method) { return errors[method]; });
  methods.resize(std::min(count, methods.size()));
  return methods;
}

/// Leaves the rows that decide and those of the best methods, of the sections with the largest deciding
/// errors. Keeps their order.
void shorten(std::vector<Section>& sections) {
  constexpr std::size_t max_sections = 8, max_methods = 3;
  const auto error = [](const Section& section) {
    return largest_error(section.rows, [](const ComparisonRow& row) { return row.decides; });
  };
  std::vector<double> errors;
  for (const Section& section : sections) errors.push_back(error(section));
  std::ranges::sort(errors, std::greater());
  if (sections.size() > max_sections) {
    const double smallest = errors[max_sections - 1];
    std::size_t kept = 0;
    std::erase_if(sections,
                  [&](const Section& section) { return error(section) < smallest || ++kept > max_sections; });
  }
  for (Section& section : sections) {
    const std::vector<std::string> best = best_methods(section.rows, max_methods);
    std::erase_if(section.rows, [&](const ComparisonRow* row) {
      return !row->decides && std::ranges::find(best, row->method) == best.end();
    });
  }
}

}  // namespace

std::string verdict_table(const VerdictDocument& document, bool shows_all) {
  constexpr std::size_t long_table = 16;  // rows
  constexpr auto line = "{:<21} {:>13} {:>13}  {:<22} {:>10} {:>9}  {}\n";
  std::vector<Section> sections = sections_of(document.rows);
  const std::size_t all_sections = sections.size();
  const bool has_headings = all_sections > 1;
  if (!shows_all && document.rows.size() > long_table) shorten(sections);
  std::string table = fmt::format(line, "quantity", "run", "reference", "method", "error", "", "verdict");
  std::size_t shown = 0;
  for (const Section& section : sections) {
    if (has_headings) table += fmt::format("{}, swimmer {}:\n", section.run_file, section.swimmer);
    for (const ComparisonRow* row : section.rows)
      table += fmt::format(line, quantity_text(*row), fmt::format("{:.5g}", row->run),
                           fmt::format("{:.5g}", row->reference), row->method, error_text(*row),
                           uncertainty_text(*row), verdict_text(*row));
    shown += section.rows.size();
  }
  table += legend;
  if (shown < document.rows.size())
    table += fmt::format("{} rows, of methods with larger errors{}, are not shown; --all shows them\n",
                         document.rows.size() - shown,
                         sections.size() < all_sections ? " and of swimmers with smaller errors" : "");
  for (const auto& [property, run, reference] : document.scene_differences)
    table += fmt::format("allowed difference: {}: run {}, reference {}\n", property, run, reference);
  const bool pass = verdict(document.rows);
  return table + fmt::format("verdict: {}, decided by {}, tolerance {:g} %\n", pass ? "pass" : "FAIL",
                             document.decided_by,
                             100 * std::ranges::min(document.rows, {}, &ComparisonRow::tolerance).tolerance);
}

std::string verdict_line(const VerdictDocument& document) {
  std::string errors;
  for (const ComparisonRow& row : document.rows) {
    if (!row.decides) continue;
    const std::string uncertainty = uncertainty_text(row);
    errors += fmt::format("{}{} {}{}", errors.empty() ? "" : ", ", quantity_text(row), error_text(row),
                          uncertainty.empty() ? "" : " " + uncertainty);
  }
  const std::string study = study_text(document.study, 6);
  return fmt::format("{}: {} by {}: {}\n", study.empty() ? document.rows.front().run_file : study,
                     verdict(document.rows) ? "pass" : "FAIL", document.decided_by, errors);
}

}  // namespace beadswim
