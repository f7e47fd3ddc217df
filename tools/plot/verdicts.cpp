#include <algorithm>
#include <filesystem>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/documents/failure_document.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/documents/verdict_document.hpp"
#include "beadswim/tools/program.hpp"
#include "errors.hpp"
#include "plot_inputs.hpp"

namespace beadswim {
namespace {

/// Returns the method that --method names, or, without --method, the method that determined the verdict.
/// Throws InputError if the verdict does not contain the named method.
std::string method_of(const VerdictDocument& verdict, const std::vector<std::string>& named,
                      const std::string& source) {
  if (named.empty()) return verdict.decided_by;
  if (named.size() > 1)
    throw InputError("--method", "{} methods are given; name the one method whose errors are drawn",
                     named.size());
  std::set<std::string> known;
  for (const ComparisonRow& row : verdict.rows) known.insert(row.method);
  if (known.contains(named.front())) return named.front();
  const std::vector<std::string> names(known.begin(), known.end());
  throw InputError("--method", "the verdict {} has no method \"{}\"{} The verdict has the methods {}", source,
                   named.front(), format_suggestion(named.front(), names), joined(names, ", "));
}

VerdictDocument verdict_in(const SourceJson& document) {
  const std::string schema = schema_of(document.json);
  if (schema.starts_with("beadswim/run/")) {
    throw InputError("--reference",
                     "no reference is given; name a prediction or a run as the reference for the errors of "
                     "{}, or draw verdicts of beadswim-compare",
                     document.source);
  }
  if (!schema.starts_with("beadswim/verdict/")) {
    throw InputError(document.source,
                     "the document has the schema \"{}\"; give verdicts (\"beadswim/verdict/1\"), or run "
                     "records with --reference",
                     schema);
  }
  VerdictDocument verdict = verdict_from_json(document.json, document.source);
  if (!verdict.cost) {
    throw InputError(document.source,
                     "the verdict does not contain the costs of the runs, for example because a run had the "
                     "flag --no-provenance; leave this file out");
  }
  return verdict;
}

ErrorsOfSetting errors_of(const VerdictDocument& verdict, const std::string& method,
                          const std::string& source) {
  ErrorsAtResolution result{.source = source, .cost = verdict.cost->core_seconds, .errors = {}};
  for (const ResultQuantity quantity : {ResultQuantity::velocity, ResultQuantity::arm_amplitudes}) {
    std::vector<double> errors;
    for (const ComparisonRow& row : verdict.rows)
      if (row.quantity == quantity && row.method == method) errors.push_back(row.relative_error);
    if (!errors.empty()) result.errors[quantity] = root_mean_square(errors);
  }
  return {std::filesystem::path(source).filename().string(), {result}};
}

}  // namespace

std::vector<ErrorsOfSetting> read_verdicts(const std::vector<std::string>& files,
                                           const std::vector<std::string>& named,
                                           std::set<std::string>& drawn) {
  if (files.empty())
    throw InputError("FILES", "no file is given; name verdicts, or run records and --reference");
  std::vector<ErrorsOfSetting> all;
  int failures = 0;
  for (const std::string& path : files) {
    for (const SourceJson& document : read_json_documents(path, "a verdict")) {
      if (is_failure(document.json)) {
        ++failures;
        continue;
      }
      const VerdictDocument verdict = verdict_in(document);
      const std::string method = method_of(verdict, named, document.source);
      drawn.insert(method);
      all.push_back(errors_of(verdict, method, document.source));
    }
  }
  report_left_out("beadswim-plot", failures, static_cast<int>(all.size()) + failures);
  const auto has_errors = [](const ErrorsOfSetting& each) { return !each.resolutions[0].errors.empty(); };
  if (std::ranges::none_of(all, has_errors))
    throw InputError(
        all.front().resolutions[0].source,
        "the verdict compares neither velocity nor arm_amplitudes; this figure needs one of them");
  return all;
}

}  // namespace beadswim
