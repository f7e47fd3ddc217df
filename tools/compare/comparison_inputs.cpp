#include "comparison_inputs.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/documents/results.hpp"
#include "beadswim/scene/units.hpp"

namespace beadswim {
namespace {

/// Throws InputError if the document is the record of a failed run, whose results are not valid, or of a
/// large swarm without a cycle.
void require_success(const SwimmingDocument& document, const std::string& source) {
  const auto* run = std::get_if<RunRecord>(&document);
  if (run == nullptr) return;
  if (run->swimmers.empty()) select_cycles({}, {}, source);
  if (run->status != RunStatus::failed) return;
  throw InputError(source,
                   "the file is the record of a failed run; correct the cause of the failure and run again");
}

// --- Check that the documents describe the same scene

/// Returns the differences between the scenes of run and reference. Throws InputError if the units differ, or
/// if --allow-difference does not name one of the differences.
std::vector<SceneDifference> require_same_scene(const RunFile& run, const SourceDocument& reference,
                                                const std::vector<std::string>& allowed) {
  if (!same_units(run.record.units, units_of(reference.document))) {
    throw InputError(reference.source, fmt::format("the reference has other units of length, time or mass "
                                                   "than {}; compare files made from the same layout",
                                                   run.source));
  }
  const std::vector<SceneDifference> differences = scene_differences(run.record, reference.document);
  std::vector<std::string> names, refused;
  for (const SceneDifference& difference : differences) {
    names.push_back(difference.property);
    if (std::ranges::find(allowed, difference.property) == allowed.end())
      refused.push_back(in_words(difference));
  }
  if (refused.empty()) return differences;
  throw InputError(reference.source,
                   fmt::format("the reference was not made from the layout of the run {}: {}; compare files "
                               "made from the same layout, or allow differences with --allow-difference {}",
                               run.source, joined(refused, "; "), joined(names, ",")));
}

// --- References of one swimmer

/// Returns the axis of the swimmer for which a prediction states vectors; nullopt if it is not that of the
/// layout, because the drives turn the swimmer.
std::optional<Vec3> predicted_axis(const PredictionDocument& document, const Prediction& prediction) {
  if (!document.scene || number_setting(prediction, "turn")) return std::nullopt;
  const auto swimmer = std::ranges::find(document.scene->swimmers, document.swimmer, &Swimmer::id);
  if (swimmer == document.scene->swimmers.end()) return std::nullopt;
  return swimmer->orientation().col(0);
}

/// Returns a swimmer of a run.
RunSwimmer swimmer_in(const RunRecord& run, int id, const CycleChoice& cycle, const std::string& source) {
  const SwimmerRecord& swimmer = find_swimmer(run, id, source);
  return {.source = source,
          .id = id,
          .results = results_of(run, swimmer, cycle, source, RunUncertainty::of_cycle),
          .scale = motion_scale_of(run, swimmer, cycle, source),
          .axis = select_cycles(swimmer.cycles, cycle, source).back().axis};
}

/// Returns the references for a swimmer that one file contains: one reference for a run record, one per
/// method for predictions.
std::vector<Reference> references_for(int id, const SourceDocument& file, const CycleChoice& cycle) {
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
  if (document.swimmer != id) return references;
  const Layout* scene = document.scene ? &*document.scene : nullptr;
  for (const Prediction& prediction : document.predictions) {
    references.push_back({.source = file.source,
                          .method = prediction.method,
                          .usable = prediction.usable,
                          .results = results_of(prediction, scene, id),
                          .numerical_error = number_setting(prediction, "numerical_error").value_or(0),
                          .axis = predicted_axis(document, prediction)});
  }
  return references;
}

/// References for one swimmer from all files. The first `own` references are from REFERENCE, the last file
/// argument of the command line.
struct References {
  std::vector<Reference> all;
  std::size_t own = 0;
};

References references_for(int swimmer, const ComparisonInputs& inputs, const CycleChoice& cycle) {
  References references{references_for(swimmer, inputs.references.front(), cycle)};
  references.own = references.all.size();
  for (const SourceDocument& file : std::span(inputs.references).subspan(1)) {
    const std::vector<Reference> more = references_for(swimmer, file, cycle);
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
    throw InputError("--method",
                     fmt::format("no reference contains the method \"{}\"{} Available methods: {}", method,
                                 format_suggestion(method, names), joined(names, ", ")));
  }
  if (!found->usable) {
    throw InputError("--method", fmt::format("the method \"{}\" is marked unusable for this layout in {} and "
                                             "cannot decide the verdict; name another method",
                                             method, found->source));
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
  const References references = references_for(id, inputs, request.cycle);
  std::vector<RunSwimmer> in_runs;
  for (const RunFile& run : inputs.runs)
    in_runs.push_back(swimmer_in(run.record, id, request.cycle, run.source));
  // A swimmer with fewer than two bonds has no phase shift.
  std::erase_if(request.quantities,
                [&](ResultQuantity quantity) { return !in_runs.front().results.contains(quantity); });
  if (request.quantities.empty())
    throw InputError(in_runs.front().source, fmt::format("swimmer {} has none of the compared quantities "
                                                         "(arm amplitudes need one arm, a phase shift two); "
                                                         "select another one with --quantity",
                                                         id));
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
  result.study = inputs.runs.front().record.study.value_or(Json());
  for (const int id : swimmers_of(inputs.references.front().document)) {
    compare_swimmer_in_all_runs(id, request, inputs, result);
  }
  if (result.rows.empty())
    throw InputError(
        inputs.runs.front().source,
        "no compared quantity is defined, because the phases are those of arms that do not move; "
        "select another one with --quantity");
  return result;
}

}  // namespace beadswim
