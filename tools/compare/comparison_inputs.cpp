#include "comparison_inputs.hpp"

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/documents/results.hpp"

namespace beadswim {
namespace {

// --- Check that the documents describe the same scene

/// Returns the differences between the scenes of run and reference. Throws InputError if the units differ, or
/// if --allow-difference does not name one of the differences.
std::vector<SceneDifference> require_same_scene(const RunFile& run, const SourceDocument& reference,
                                                const std::vector<std::string>& allowed) {
  if (run.record.units != units_of(reference.document)) {
    throw InputError(reference.source,
                     "the reference has other units of length, time or mass than {}; compare files made from "
                     "the same layout",
                     run.source);
  }
  const std::vector<SceneDifference> differences = scene_differences(run.record, reference.document);
  std::vector<std::string> names, refused;
  for (const SceneDifference& difference : differences) {
    names.push_back(difference.name);
    if (std::ranges::find(allowed, difference.name) == allowed.end()) refused.push_back(in_words(difference));
  }
  if (refused.empty()) return differences;
  throw InputError(reference.source,
                   "the reference was not made from the layout of the run {}: {}; compare files made from "
                   "the same layout, or allow differences with --allow-difference {}",
                   run.source, joined(refused, "; "), joined(names, ","));
}

// --- References of one swimmer

/// Returns a swimmer of a run.
RunSwimmer swimmer_in(const RunRecord& run, int id, const CycleChoice& cycle, const std::string& source) {
  const SwimmerRecord& swimmer = find_swimmer(run, id, source);
  return {.source = source,
          .id = id,
          .results = results_of(run, swimmer, cycle, source, RunUncertainty::of_cycle),
          .scale = motion_scale_of(run, swimmer, cycle, source),
          .axis = select_cycles(swimmer.cycles, cycle, source).back().axis};
}

/// Returns true if the predictions are valid for the swimmer: it is theirs, or, if the request names it, one
/// with the same parameters in the scene of the predictions or of the run.
bool are_valid_for(int id, const PredictionDocument& document, const RunRecord& run, bool is_named) {
  if (document.swimmer == id) return true;
  const std::optional<Layout>& scene = document.scene ? document.scene : run.scene;
  return is_named && scene && are_predicted_alike(*scene, document.swimmer, id);
}

/// Returns the references for a swimmer that one file contains: one reference for a run record, one per
/// method for predictions.
std::vector<Reference> references_for(int id, const SourceDocument& file, const RunRecord& compared,
                                      const ComparisonRequest& request) {
  const CycleChoice& cycle = request.cycle;
  if (const auto* run = std::get_if<RunRecord>(&file.document)) {
    const RunSwimmer swimmer = swimmer_in(*run, id, cycle, file.source);
    return {Reference{.source = file.source,
                      .method = "run",
                      .usable = true,
                      .results = swimmer.results,
                      .numerical_error = swimmer.scale.numerical_error,
                      .axis = swimmer.axis}};
  }
  std::vector<Reference> references;
  const auto& document = std::get<PredictionDocument>(file.document);
  if (!are_valid_for(id, document, compared, request.swimmer.has_value())) return references;
  const Layout* scene = document.scene ? &*document.scene : nullptr;
  for (const Prediction& prediction : document.predictions) {
    references.push_back({.source = file.source,
                          .method = prediction.method,
                          .usable = prediction.usable,
                          .results = results_of(prediction, scene, document.swimmer),
                          .numerical_error = find_setting<double>(prediction, "numerical_error").value_or(0),
                          .axis = predicted_axis(prediction, scene, document.swimmer)});
  }
  return references;
}

/// References for one swimmer from all files. The first `own` references are from REFERENCE, the last file
/// argument of the command line.
struct References {
  std::vector<Reference> all;
  std::size_t own = 0;
};

/// Throws InputError if REFERENCE contains predictions for another swimmer only.
References references_for(int swimmer, const ComparisonInputs& inputs, const ComparisonRequest& request) {
  const SourceDocument& reference = inputs.references.front();
  const RunRecord& run = inputs.runs.front().record;
  References references{references_for(swimmer, reference, run, request)};
  references.own = references.all.size();
  if (references.all.empty())
    throw InputError(reference.source,
                     "the predictions are for swimmer {}, and not valid for swimmer {}; predict with "
                     "beadswim-theory --swimmer {}",
                     swimmers_of(reference.document).front(), swimmer, swimmer);
  for (const SourceDocument& file : std::span(inputs.references).subspan(1)) {
    const std::vector<Reference> more = references_for(swimmer, file, run, request);
    references.all.insert(references.all.end(), more.begin(), more.end());
  }
  return references;
}

// --- Reference that determines the verdict

/// Returns the index of the first reference whose method has this name. Throws InputError if no reference has
/// this method, or if its prediction is not usable.
std::size_t reference_named(const std::string& method, std::span<const Reference> references) {
  const auto found = std::ranges::find(references, method, &Reference::method);
  if (found == references.end()) {
    std::vector<std::string> names;
    for (const Reference& reference : references) names.push_back(reference.method);
    throw InputError("--method", "no reference contains the method \"{}\"{} Available methods: {}", method,
                     format_suggestion(method, names), joined(names, ", "));
  }
  if (!found->usable) {
    throw InputError("--method",
                     "the method \"{}\" is marked unusable for this layout in {} and cannot decide the "
                     "verdict; name another method",
                     method, found->source);
  }
  return static_cast<std::size_t>(found - references.begin());
}

/// Returns the index of the reference that determines the verdict: the method of --method, otherwise the best
/// usable method of the file REFERENCE. Throws InputError if there is no such reference.
std::size_t deciding_reference(const ComparisonRequest& request, const References& references) {
  if (request.method) return reference_named(*request.method, references.all);
  const auto best = best_reference(std::span(references.all).first(references.own), request.quantities);
  if (best) return *best;
  throw InputError(source_name(request.files.back()),
                   "the prediction contains no usable method to decide the verdict; predict with other "
                   "methods (beadswim-theory --method)");
}

/// Compares one swimmer of every run with all references, and adds the rows to `result`.
void compare_swimmer_in_all_runs(int id, ComparisonRequest request, const ComparisonInputs& inputs,
                                 VerdictDocument& result) {
  std::vector<RunSwimmer> in_runs;
  for (const RunFile& run : inputs.runs)
    in_runs.push_back(swimmer_in(run.record, id, request.cycle, run.source));
  const References references = references_for(id, inputs, request);
  // A swimmer with fewer than two bonds has no phase shift.
  std::erase_if(request.quantities,
                [&](ResultQuantity quantity) { return !in_runs.front().results.contains(quantity); });
  if (request.quantities.empty())
    throw InputError(in_runs.front().source,
                     "swimmer {} has none of the compared quantities (arm amplitudes need one arm, a phase "
                     "shift two); select another one with --quantity",
                     id);
  const std::size_t deciding = deciding_reference(request, references);
  result.decided_by = references.all[deciding].method;
  for (const RunSwimmer& in_run : in_runs) {
    const auto rows = compare_swimmer(
        in_run, references.all,
        {.quantities = request.quantities, .tolerance = request.tolerance, .deciding = deciding});
    result.rows.insert(result.rows.end(), rows.begin(), rows.end());
  }
}

}  // namespace

void require_success(const SwimmingDocument& document, const std::string& source) {
  const auto* run = std::get_if<RunRecord>(&document);
  if (run == nullptr) return;
  if (run->swimmers.empty()) select_cycles({}, {}, source);
  if (run->status != RunStatus::failed) return;
  throw InputError(source,
                   "the file is the record of a failed run; correct the cause of the failure and run again");
}

VerdictDocument compare(const ComparisonInputs& inputs, const ComparisonRequest& request) {
  VerdictDocument result;
  std::vector<std::optional<RunCost>> costs;
  for (const RunFile& run : inputs.runs) require_success(run.record, run.source);
  for (const SourceDocument& reference : inputs.references)
    require_success(reference.document, reference.source);
  for (const RunFile& run : inputs.runs) {
    for (const SourceDocument& reference : inputs.references)
      for (const SceneDifference& difference :
           require_same_scene(run, reference, request.allowed_differences))
        if (std::ranges::find(result.scene_differences, difference) == result.scene_differences.end())
          result.scene_differences.push_back(difference);
    costs.push_back(run.record.cost);
  }
  result.cost = total_cost(costs);
  result.study = inputs.runs.front().study();
  const std::vector<int> ids =
      request.swimmer ? std::vector{*request.swimmer} : swimmers_of(inputs.references.front().document);
  for (const int id : ids) compare_swimmer_in_all_runs(id, request, inputs, result);
  if (result.rows.empty())
    throw InputError(inputs.runs.front().source,
                     "no compared quantity is defined: the method \"{}\" does not state it, or it is the "
                     "phase of an arm that does not move; select another --quantity",
                     result.decided_by);
  return result;
}

}  // namespace beadswim
