#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/names.hpp"
#include "beadswim/documents/layout_document.hpp"
#include "beadswim/documents/study_result.hpp"

// Velocity, power and other outcomes of a layout, by a theory method or by a model.

namespace beadswim {

/// Quantities that are searched or limited.
enum class Outcome {
  velocity,          ///< along the axis of the swimmer, relative to the mean flow [length/time]
  angular_velocity,  ///< its size [radian/time]
  efficiency,        ///< Lighthill efficiency
  power,             ///< mean power of the drives [mass length^2/time^3]
  gap,               ///< smallest gap between the two beads of an arm during a stroke [length]
};

template <>
inline constexpr auto name_table<Outcome> =
    std::to_array<NamedValue<Outcome>>({{Outcome::velocity, "velocity"},
                                        {Outcome::angular_velocity, "angular_velocity"},
                                        {Outcome::efficiency, "efficiency"},
                                        {Outcome::power, "power"},
                                        {Outcome::gap, "gap"}});

/// Outcomes that the method or the model gives, with the uncertainties that it states.
using Outcomes = std::map<Outcome, ResultValue>;

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
