#include "relative_velocity.hpp"

#include <fmt/core.h>

#include <cmath>

#include "beadswim/core/error.hpp"

namespace beadswim {

const Prediction& reference_at(const PlotInputs& inputs, Abscissa abscissa, double x,
                               const std::string& source) {
  constexpr double tolerance = 1e-9;  // relative: both come from one layout, and are copied, not computed
  const PlottedPrediction* found = nullptr;
  for (const PlottedPrediction& reference : inputs.references) {
    if (std::abs(abscissa_of(reference, abscissa) - x) > tolerance * std::abs(x)) continue;
    if (found != nullptr && found->prediction.velocity != reference.prediction.velocity) {
      throw InputError(
          reference.source,
          fmt::format("predicts another velocity than {}, both by {} at {} {:g}; give one of them",
                      found->source, reference.prediction.method, key_of(abscissa), x));
    }
    found = &reference;
  }
  if (found != nullptr) return found->prediction;
  throw InputError(source, fmt::format("no prediction by {} at {} {:g} to compare with; add one",
                                       inputs.references.front().prediction.method, key_of(abscissa), x));
}

double relative_difference(double velocity, const Prediction& reference) {
  return 100 * (velocity / reference.velocity - 1);
}

}  // namespace beadswim
