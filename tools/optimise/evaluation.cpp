#include "evaluation.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/core/nearest_name.hpp"
#include "beadswim/documents/swimming_document.hpp"
#include "beadswim/plan/run_plan.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/run/run.hpp"
#include "beadswim/theory/methods.hpp"
#include "beadswim/tools/stop_signal.hpp"
#include "predict_layout.hpp"

namespace beadswim {
namespace {

class TheoryEvaluator : public Evaluator {
 public:
  TheoryEvaluator(const std::string& method, const EvaluatorSettings& settings) {
    request_.methods = {method};
    request_.swimmer = settings.swimmer;
  }

  Outcomes evaluate(const LayoutDocument& document, const std::string& source) const override {
    const PredictionDocument predicted = predict_layout(document, source, request_, std::nullopt);
    return outcomes_of(results_of(predicted.predictions.front(), &document.layout, predicted.swimmer));
  }

 private:
  TheoryRequest request_;
};

class ModelEvaluator : public Evaluator {
 public:
  ModelEvaluator(const std::string& model, const EvaluatorSettings& settings) : swimmer_(settings.swimmer) {
    settings_.model = from_text<RunModel>(model);
    if (settings.cycles) settings_.cycles = *settings.cycles;
  }

  Outcomes evaluate(const LayoutDocument& document, const std::string& source) const override {
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

  void require_treatable(const LayoutDocument& document, const std::string& source) const override {
    plan_for(task(document, source), communicator_);
  }

 private:
  RunTask task(const LayoutDocument& document, const std::string& source) const {
    return {.document = document, .settings = settings_, .source = source};
  }

  RunRecord record_of(const LayoutDocument& document, const std::string& source) const {
    RunTask wanted = task(document, source);
    const std::unique_ptr<ModelPlan> plan = plan_for(wanted, communicator_);
    reason_against([&] { plan->expected = expected_errors(document.layout, *plan); });
    const RunSinks sinks{.stop = []() -> std::optional<StopRequest> {
      if (stop_signal() == 0) return std::nullopt;
      return StopRequest{.reason = fmt::format("the run was stopped by signal {}", stop_signal())};
    }};
    RunResult result = run(wanted, *plan, sinks, communicator_);
    if (result.record.status == RunStatus::stopped_signal) throw StoppedEarly(result.record.reason);
    if (result.record.status != RunStatus::finished) throw SolverError(result.record.reason);
    return std::move(result.record);
  }

  std::vector<const SwimmerRecord*> chosen(const RunRecord& record, const std::string& source) const {
    if (swimmer_) return {&find_swimmer(record, *swimmer_, source)};
    if (record.swimmers.empty())
      throw InputError(source,
                       "records of more than 64 swimmers do not list them; name one with --swimmer, or make "
                       "a smaller cell with beadswim-layout reduce");
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

  Communicator communicator_{MPI_COMM_SELF};
  RunSettings settings_;
  std::optional<int> swimmer_;
};

}  // namespace

Outcomes outcomes_of(const Results& results) {
  Outcomes outcomes;
  for (const auto& [quantity, value] : results)
    if (!row_of(quantity).is_per_arm)
      outcomes[quantity] = {.value = value.numbers.front(), .error = value.error(0)};
  return outcomes;
}

std::unique_ptr<Evaluator> theory_evaluator(const std::string& name, const std::string& flag,
                                            const std::vector<std::string>& others,
                                            const EvaluatorSettings& settings) {
  const auto method = std::ranges::find(methods(), name, &Method::name);
  if (method == methods().end()) {
    std::vector<std::string> names;
    for (const Method& each : methods())
      if (each.input != Method::Input::stroke) names.push_back(each.name);
    names.insert(names.end(), others.begin(), others.end());
    throw InputError(flag, format_unknown_name(name, names));
  }
  if (method->input == Method::Input::stroke)
    throw InputError(flag, fmt::format("{} needs a measured stroke, which belongs to one layout; name a "
                                       "method that computes the stroke",
                                       name));
  return std::make_unique<TheoryEvaluator>(name, settings);
}

std::unique_ptr<Evaluator> model_evaluator(const std::string& name, const EvaluatorSettings& settings) {
  return std::make_unique<ModelEvaluator>(name, settings);
}

bool is_model(const std::string& name) {
  const auto model = value_named<RunModel>(name);
  return model && *model != RunModel::automatic;
}

}  // namespace beadswim
