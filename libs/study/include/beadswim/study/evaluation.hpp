#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "beadswim/core/setting.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/results.hpp"
#include "beadswim/run/run.hpp"

// Velocity, power and other outcomes of a layout, by a theory method or by a model.

namespace beadswim {

/// Value of a result with one number, and its absolute uncertainty; 0 if none is stated.
struct Outcome {
  double value = 0, error = 0;
};

/// Outcomes that the method or the model gives.
using Outcomes = std::map<ResultQuantity, Outcome>;

/// A theory method or a model that evaluates layouts. `source`: name of the layout in messages.
struct Evaluator {
  std::string name;
  /// Returns the outcomes of a layout. Throws InputError or SolverError with the reason if the layout cannot
  /// be treated, StoppedEarly after a request to stop.
  std::function<Outcomes(const LayoutDocument&, const std::string& source)> evaluate;
  /// Throws InputError if a model cannot run the layout, as far as this is known before the run; empty: a
  /// method of theory.
  std::function<void(const LayoutDocument&, const std::string& source)> require_treatable{};
};

/// Settings of evaluators.
struct EvaluatorSettings {
  std::optional<int> swimmer;    ///< id; nullopt: theory for all, which must be equal; models: their mean
  std::optional<double> cycles;  ///< length of a run by a model [base period]; nullopt: as by default
  std::function<std::optional<EarlyStop>()> stop{};  ///< of a run (RunSinks)
};

/// Returns whether the name is that of a model. Its evaluator makes runs on one rank, whose last cycles
/// count, and needs an MpiSession.
bool is_model(const std::string& name);

/// Returns the evaluator by the model or the theory method of that name. `setting`: the setting with this
/// value. Throws InputError if there is none, or if it needs a measured stroke.
Evaluator evaluator_by(const std::string& name, Setting setting, const EvaluatorSettings& settings);

}  // namespace beadswim
