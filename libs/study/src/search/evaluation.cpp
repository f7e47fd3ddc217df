#include "beadswim/study/evaluation.hpp"

#include <fmt/core.h>

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
    throw InputError(setting, fmt::format("{} needs a measured stroke, which belongs to one layout; name a "
                                          "method that computes the stroke",
                                          name));
}

/// Makes runs by one model.
class ModelEvaluator {
 public:
  ModelEvaluator(RunModel model, const EvaluatorSettings& settings)
      : swimmer_(settings.swimmer), stop_(settings.stop) {
    settings_.model = model;
    if (settings.cycles) settings_.cycles = *settings.cycles;
  }

  Outcomes evaluate(const LayoutDocument& document, const std::string& source) const {
    const RunRecord record = record_of(document, source);
    Outcomes sum;
    const std::vector<const SwimmerRecord*> swimmers = chosen(record, source);
    for (const SwimmerRecord* swimmer : swimmers) add(record, *swimmer, source, sum);
    for (auto& [quantity, value] : sum) {
      if (quantity == ResultQuantity::gap) continue;
      value.value /= static_cast<double>(swimmers.size());
      value.error /= static_cast<double>(swimmers.size());
    }
    return sum;
  }

  RunTask task(const LayoutDocument& document, const std::string& source) const {
    return {.document = document, .settings = settings_, .source = source};
  }

 private:
  RunRecord record_of(const LayoutDocument& document, const std::string& source) const {
    const Communicator communicator(MPI_COMM_SELF);
    RunTask wanted = task(document, source);
    const std::unique_ptr<ModelPlan> plan = plan_for(wanted, communicator);
    reason_against([&] { plan->expected = expected_errors(document.layout, *plan); });
    RunRecord record = run(wanted, *plan, {.stop = stop_}, communicator).record;
    if (record.status == RunStatus::stopped_signal) throw StoppedEarly(record.reason);
    if (record.status != RunStatus::finished) throw SolverError(record.reason);
    return record;
  }

  std::vector<const SwimmerRecord*> chosen(const RunRecord& record, const std::string& source) const {
    if (swimmer_) return {&find_swimmer(record, *swimmer_, source)};
    if (record.swimmers.empty())
      throw InputError(
          source, fmt::format("records of more than 64 swimmers do not list them; name one with {}, or make "
                              "a smaller cell with beadswim-layout reduce",
                              Setting::swimmer));
    std::vector<const SwimmerRecord*> all;
    for (const SwimmerRecord& swimmer : record.swimmers) all.push_back(&swimmer);
    return all;
  }

  /// Adds the outcomes of one swimmer; the gap is that of the swimmer with the smallest.
  static void add(const RunRecord& record, const SwimmerRecord& swimmer, const std::string& source,
                  Outcomes& sum) {
    for (const auto& [quantity, outcome] : outcomes_of(results_of(record, swimmer, {}, source))) {
      const auto [found, is_first] = sum.try_emplace(quantity, outcome);
      if (is_first) continue;
      double& value = found->second.value;
      value = quantity == ResultQuantity::gap ? std::min(value, outcome.value) : value + outcome.value;
      found->second.error += outcome.error;
    }
  }

  RunSettings settings_;
  std::optional<int> swimmer_;
  std::function<std::optional<StopRequest>()> stop_;
};

}  // namespace

bool is_model(const std::string& name) {
  const auto model = value_named<RunModel>(name);
  return model && *model != RunModel::automatic;
}

Evaluator evaluator_by(const std::string& name, Setting setting, const EvaluatorSettings& settings) {
  if (is_model(name)) {
    const ModelEvaluator model(from_text<RunModel>(name), settings);
    return {.name = name,
            .evaluate = [model](const LayoutDocument& document,
                                const std::string& source) { return model.evaluate(document, source); },
            .require_treatable =
                [model](const LayoutDocument& document, const std::string& source) {
                  plan_for(model.task(document, source), Communicator(MPI_COMM_SELF));
                }};
  }
  require_method(name, setting);
  const PredictionRequest request{.methods = {name}, .swimmer = settings.swimmer};
  return {
      .name = name, .evaluate = [request](const LayoutDocument& document, const std::string& source) {
        const LayoutPredictions predicted = predict_layout(document.layout, source, request);
        return outcomes_of(results_of(predicted.predictions.front(), &document.layout, predicted.swimmer));
      }};
}

}  // namespace beadswim
