#include "beadswim/study/evaluation.hpp"

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/core/names.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/plan/run_plan.hpp"
#include "beadswim/theory/layout_predictions.hpp"
#include "beadswim/theory/methods.hpp"

namespace beadswim {
namespace {

Outcomes outcomes_of(const Results& results) {
  Outcomes outcomes;
  for (const auto& [quantity, value] : results)
    if (!row_of(quantity).is_per_arm)
      outcomes[quantity] = {.value = value.numbers.front(), .error = value.error(0)};
  return outcomes;
}

/// Throws InputError if no method has this name, or if it needs a measured stroke.
void require_method(const std::string& name, Setting setting) {
  const auto method = std::ranges::find(methods(), name, &Method::name);
  if (method == methods().end()) {
    std::vector<std::string> names;
    for (const Method& each : methods())
      if (each.input != Method::Input::stroke) names.push_back(each.name);
    if (setting == Setting::verification)
      std::ranges::copy_if(all_names<RunModel>(), std::back_inserter(names), is_model);
    throw InputError(setting, format_unknown_name(name, names));
  }
  if (method->input == Method::Input::stroke)
    throw InputError(
        setting,
        "{} needs a measured stroke, which belongs to one layout; name a method that computes the stroke",
        name);
}

/// Makes a run on one rank and returns its record.
RunRecord record_of(RunTask task, const std::function<std::optional<EarlyStop>()>& stop) {
  const Communicator communicator(MPI_COMM_SELF);
  const std::unique_ptr<ModelPlan> plan = plan_for(task, communicator);
  reason_against([&] { plan->expected = expected_errors(task.document.layout, *plan); });
  RunRecord record = run(task, *plan, {.stop = stop}, communicator).record;
  if (record.status == RunStatus::stopped_signal) throw StoppedEarly(record.reason);
  if (record.status != RunStatus::finished) throw SolverError(record.reason);
  return record;
}

/// Returns the swimmer with the id `chosen`, or all.
std::vector<const SwimmerRecord*> chosen_swimmers(const RunRecord& record, const std::optional<int>& chosen,
                                                  const std::string& source) {
  if (chosen) return {&find_swimmer(record, *chosen, source)};
  if (record.swimmers.empty())
    throw InputError(source,
                     "records of more than 64 swimmers do not list them; name one with {}, or make a smaller "
                     "cell with beadswim-layout reduce",
                     Setting::swimmer);
  std::vector<const SwimmerRecord*> all;
  for (const SwimmerRecord& swimmer : record.swimmers) all.push_back(&swimmer);
  return all;
}

/// Returns the means of the outcomes of swimmers; the gap is that of the swimmer with the smallest.
Outcomes mean_outcomes(const RunRecord& record, const std::vector<const SwimmerRecord*>& swimmers,
                       const std::string& source) {
  Outcomes sum;
  for (const SwimmerRecord* swimmer : swimmers) {
    for (const auto& [quantity, outcome] : outcomes_of(results_of(record, *swimmer, {}, source))) {
      const auto [found, is_first] = sum.try_emplace(quantity, outcome);
      if (is_first) continue;
      double& value = found->second.value;
      value = quantity == ResultQuantity::gap ? std::min(value, outcome.value) : value + outcome.value;
      found->second.error += outcome.error;
    }
  }
  for (auto& [quantity, outcome] : sum) {
    if (quantity == ResultQuantity::gap) continue;
    outcome.value /= static_cast<double>(swimmers.size());
    outcome.error /= static_cast<double>(swimmers.size());
  }
  return sum;
}

/// Returns the evaluator by runs of a model.
Evaluator evaluator_by_model(const std::string& name, const EvaluatorSettings& settings) {
  RunSettings of_run;
  of_run.model = from_text<RunModel>(name);
  if (settings.cycles) of_run.cycles = *settings.cycles;
  const auto task = [of_run](const LayoutDocument& document, const std::string& source) {
    return RunTask{.document = document, .settings = of_run, .source = source};
  };
  const auto evaluate = [task, settings](const LayoutDocument& document, const std::string& source) {
    const RunRecord record = record_of(task(document, source), settings.stop);
    return mean_outcomes(record, chosen_swimmers(record, settings.swimmer, source), source);
  };
  const auto require_treatable = [task](const LayoutDocument& document, const std::string& source) {
    plan_for(task(document, source), Communicator(MPI_COMM_SELF));
  };
  return {.name = name, .evaluate = evaluate, .require_treatable = require_treatable};
}

}  // namespace

bool is_model(const std::string& name) {
  const auto model = value_named<RunModel>(name);
  return model && *model != RunModel::automatic;
}

Evaluator evaluator_by(const std::string& name, Setting setting, const EvaluatorSettings& settings) {
  if (is_model(name)) return evaluator_by_model(name, settings);
  require_method(name, setting);
  const PredictionRequest request{.methods = {name}, .swimmer = settings.swimmer};
  return {
      .name = name, .evaluate = [request](const LayoutDocument& document, const std::string& source) {
        const LayoutPredictions predicted = predict_layout(document.layout, source, request);
        return outcomes_of(results_of(predicted.predictions.front(), &document.layout, predicted.swimmer));
      }};
}

}  // namespace beadswim
