#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/results.hpp"

// Velocity, power and other outcomes of a layout, by a theory method or by a model.

namespace beadswim {

/// Value of a result with one number, and its absolute uncertainty; 0 if none is stated.
struct Outcome {
  double value = 0, error = 0;
};

/// Outcomes that the method or the model gives.
using Outcomes = std::map<ResultQuantity, Outcome>;

/// Returns the results that have one number, which can be searched or limited.
Outcomes outcomes_of(const Results& results);

/// Outcomes of which a trace states all, and messages those that a method or model gives.
inline constexpr std::array usual_outcomes{ResultQuantity::velocity, ResultQuantity::angular_velocity,
                                           ResultQuantity::efficiency, ResultQuantity::power,
                                           ResultQuantity::gap};

/// Evaluates layouts by one theory method or one model.
class Evaluator {
 public:
  virtual ~Evaluator() = default;

  /// Returns the outcomes of a layout. Throws InputError or SolverError with the reason if the layout cannot
  /// be treated. `source`: name of the layout in messages.
  virtual Outcomes evaluate(const LayoutDocument& document, const std::string& source) const = 0;

  /// Throws InputError if a layout cannot be treated, as far as this is known before it is evaluated.
  virtual void require_treatable(const LayoutDocument&, const std::string&) const {}
};

/// Settings of evaluators.
struct EvaluatorSettings {
  std::optional<int> swimmer;    ///< id; nullopt: theory for all, which must be equal; models: their mean
  std::optional<double> cycles;  ///< length of a run by a model [base period]; nullopt: as beadswim-run
};

/// Returns whether the name is that of a model of beadswim-run. Its evaluator makes runs on one rank, whose
/// last cycles count, and needs an MpiSession.
bool is_model(const std::string& name);

/// Returns the evaluator by the theory method of that name. Throws InputError if there is none, or if it
/// needs a measured stroke. `flag`: flag of the command line for the message; `others`: names that the flag
/// takes too.
std::unique_ptr<Evaluator> theory_evaluator(const std::string& name, const std::string& flag,
                                            const std::vector<std::string>& others,
                                            const EvaluatorSettings& settings);

/// Returns the evaluator by the model of that name.
std::unique_ptr<Evaluator> model_evaluator(const std::string& name, const EvaluatorSettings& settings);

}  // namespace beadswim
