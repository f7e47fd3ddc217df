#include "verdicts.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/verdict_document.hpp"
#include "beadswim/figure/error_figure.hpp"
#include "plot_inputs.hpp"
#include "plot_labels.hpp"

namespace beadswim {
namespace {

struct PlottedVerdict {
  std::string source;
  VerdictDocument verdict;
  std::string method;  ///< method relative to which errors are drawn
};

/// Returns the method that --method names, or, without --method, the method that determined the verdict.
/// Throws InputError if the verdict does not contain the named method.
std::string method_of(const VerdictDocument& verdict, const std::vector<std::string>& named,
                      const std::string& source) {
  if (named.empty()) return verdict.decided_by;
  if (named.size() > 1)
    throw InputError(
        "--method",
        fmt::format("{} methods are given; name the one method whose errors are drawn", named.size()));
  std::set<std::string> known;
  for (const ComparisonRow& row : verdict.rows) known.insert(row.method);
  if (known.contains(named.front())) return named.front();
  const std::vector<std::string> names(known.begin(), known.end());
  throw InputError(
      "--method",
      fmt::format("the verdict {} has no method \"{}\"{} The verdict has the methods {}", source,
                  named.front(), format_suggestion(named.front(), names), fmt::join(names, ", ")));
}

PlottedVerdict verdict_in(const SourceJson& document, const std::vector<std::string>& methods) {
  const std::string schema = schema_of(document.json);
  if (schema.starts_with("beadswim/run/")) {
    throw InputError("--reference",
                     fmt::format("no reference is given; name a prediction or a run as the reference for the "
                                 "errors of {}, or draw verdicts of beadswim-compare",
                                 document.source));
  }
  if (!schema.starts_with("beadswim/verdict/")) {
    throw InputError(document.source, fmt::format("the document has the schema \"{}\"; give verdicts "
                                                  "(\"beadswim/verdict/1\"), or run records with --reference",
                                                  schema));
  }
  VerdictDocument verdict = verdict_from_json(document.json, document.source);
  if (!verdict.cost) {
    throw InputError(document.source,
                     "the verdict does not contain the costs of the runs, for example because a run had the "
                     "flag --no-provenance; leave this file out");
  }
  std::string method = method_of(verdict, methods, document.source);
  return {document.source, std::move(verdict), std::move(method)};
}

std::vector<PlottedVerdict> read_verdicts(const std::vector<std::string>& files,
                                          const std::vector<std::string>& methods) {
  if (files.empty())
    throw InputError("FILES", "no file is given; name verdicts, or run records and --reference");
  std::vector<PlottedVerdict> verdicts;
  int failures = 0;
  for (const std::string& path : files) {
    for (const SourceJson& document : read_json_documents(path, "a verdict")) {
      if (is_failure(document.json))
        ++failures;
      else
        verdicts.push_back(verdict_in(document, methods));
    }
  }
  report_left_out(failures, static_cast<int>(verdicts.size()) + failures);
  return verdicts;
}

/// Returns the errors of one quantity: one series for each verdict that compares this quantity.
std::vector<ErrorSeries> errors_of(const std::vector<PlottedVerdict>& verdicts, ResultQuantity quantity) {
  std::vector<ErrorSeries> all;
  for (const PlottedVerdict& plotted : verdicts) {
    std::vector<double> errors;
    for (const ComparisonRow& row : plotted.verdict.rows) {
      if (row.quantity == quantity && row.method == plotted.method) errors.push_back(row.relative_error);
    }
    if (errors.empty()) continue;
    const std::string name = std::filesystem::path(plotted.source).filename().string();
    all.push_back({name,
                   {{.name = name,
                     .source = plotted.source,
                     .cost = plotted.verdict.cost->core_seconds,
                     .error = root_mean_square(errors)}}});
  }
  return all;
}

Note methods_note(const std::vector<PlottedVerdict>& verdicts) {
  std::set<std::string> methods;
  for (const PlottedVerdict& plotted : verdicts) methods.insert(plotted.method);
  return {.text = fmt::format(
              "Marks are verdicts: root mean square of errors relative to {}, and core-seconds of "
              "complete runs.",
              summarise_names(methods, "methods"))};
}

}  // namespace

Figure verdict_figure(const std::vector<std::string>& files, const std::vector<std::string>& methods) {
  const std::vector<PlottedVerdict> verdicts = read_verdicts(files, methods);
  std::vector<QuantityErrors> quantities;
  for (const auto& [quantity, name] : {std::pair(ResultQuantity::velocity, "velocity"),
                                       std::pair(ResultQuantity::arm_amplitudes, "arm amplitudes")}) {
    std::vector<ErrorSeries> all = errors_of(verdicts, quantity);
    if (!all.empty()) quantities.push_back({name, std::move(all)});
  }
  if (quantities.empty()) {
    throw InputError(
        verdicts.front().source,
        "the verdict compares neither velocity nor arm_amplitudes; this figure needs one of them");
  }
  return error_figure(quantities, "core-seconds", {methods_note(verdicts)});
}

}  // namespace beadswim
