#include "beadswim/plan/model_errors.hpp"

#include <algorithm>
#include <cmath>

#include "beadswim/theory/methods.hpp"

namespace beadswim {
namespace {

Prediction predicted(const char* method, const Question& question) {
  return predict(find_method(method), question);
}

/// Numbers of a model without inertia in the question's surroundings.
struct Numbers {
  double velocity = 0;
  std::array<double, 2> arm_amplitudes{};
};

Numbers numbers_of(const Prediction& prediction) {
  return {.velocity = prediction.velocity, .arm_amplitudes = prediction.stroke.amplitude};
}

/// Rotne and Prager's beads in the box, and what the model makes of the swimmer alone beyond them: for the
/// stroke that it has in the box.
Numbers in_box(const Question& question, const char* method_in_open_space) {
  const Prediction pairs_in_box = predicted("rpy-box-ode", question);
  const Prediction pairs = predicted("rpy-ode", question), model = predicted(method_in_open_space, question);
  const double area = pairs.stroke.area() != 0 ? pairs_in_box.stroke.area() / pairs.stroke.area() : 1;
  Numbers numbers = numbers_of(pairs_in_box);
  numbers.velocity += (model.velocity - pairs.velocity) * area;
  for (int arm = 0; arm < 2; ++arm) {
    if (pairs.stroke.amplitude[arm] > 0)
      numbers.arm_amplitudes[arm] *= model.stroke.amplitude[arm] / pairs.stroke.amplitude[arm];
  }
  return numbers;
}

const char* method_of(MobilityModel model) {
  if (model == MobilityModel::oseen) return "oseen-ode";
  return model == MobilityModel::rpy ? "rpy-ode" : "multipole-ode";
}

/// Below this estimates were not held against anything: references of docs/speed-against-error.md are known
/// to 0.2 and 0.4 %.
constexpr double least_known = 0.002;

double relative(double value, double reference) {
  return reference != 0 ? std::abs(value / reference - 1) : 0;
}

/// How much worse than mr a boundary scatters over places within a cell (docs/resolution.md).
double scatter_over_mr(BeadScheme scheme) {
  return scheme == BeadScheme::mr ? 1 : scheme == BeadScheme::staircase ? 4 : 1.5;
}

/// What cells alone are wrong by: docs/speed-against-error.md at short steps, docs/hard-cases.md below 2
/// cells a radius. The mobility of a bead on a lattice varies with its place in a cell; a swing over several
/// cells takes the mean of that, a short one adds its slope to that of the flow. `swing`: of the arm that
/// moves less [cell].
ErrorEstimate error_of_cells(double cells_per_radius, BeadScheme scheme, double swing) {
  constexpr double shortest = 0.2;  // where the slope is all [cell]
  const double n2 = cells_per_radius * cells_per_radius, n5 = n2 * n2 * cells_per_radius;
  const double by_place = 0.114 / std::pow(cells_per_radius, 1.7) / std::pow(std::max(swing, shortest), 2.5);
  const double arm = 0.03 / n2 + 0.05 / n5, scatter = scatter_over_mr(scheme);
  return {.velocity = scatter * (0.045 / n2 + by_place), .arm_amplitudes = {scatter * arm, scatter * arm}};
}

/// What gaps that cells do not resolve are wrong by: at rest, docs/hard-cases.md "contact at the start", and
/// where beads come as near only in their stroke, "driving".
ErrorEstimate error_of_gaps(double at_rest, double nearest) {
  constexpr double resolved = 2.5, least = 1, touching = 0.25;  // [cell]
  constexpr double unresolved = 0.25, passing = 0.04;
  const double lack = std::clamp((resolved - at_rest) / (resolved - least), 0.0, 1.0);
  const double standing = unresolved * lack * lack;
  const double swinging = nearest < touching ? passing : 0;
  const double arm = standing / 2 + swinging;
  return {.velocity = standing + swinging, .arm_amplitudes = {arm, arm}};
}

double nearest_in_stroke(const CollinearSwimmer& swimmer, const Prediction& motion) {
  const std::array<double, 2> at_rest = gaps_at_rest(swimmer);
  double nearest = INFINITY;
  for (int arm = 0; arm < 2; ++arm) {
    const double mean = motion.arm_means ? (*motion.arm_means)[arm] - swimmer.arm[arm] : 0;
    nearest = std::min(nearest, at_rest[arm] + mean - motion.stroke.amplitude[arm]);
  }
  return nearest;
}

}  // namespace

double ErrorEstimate::largest() const {
  return std::max({velocity, arm_amplitudes[0], arm_amplitudes[1]});
}

BestKnown best_known(const Question& question) {
  const Prediction best = predicted("inertia-corrected", question);
  BestKnown known;
  known.velocity = best.velocity;
  known.arm_amplitudes = best.stroke.amplitude;
  known.nearest = nearest_in_stroke(question.swimmer, best);
  known.swims = best.uncertainty.has_value() && best.velocity != 0;
  if (best.stroke_uncertainty) known.uncertainty.arm_amplitudes = best.stroke_uncertainty->arm_amplitudes;
  if (!known.swims) return known;
  known.uncertainty.velocity = *best.uncertainty;
  const Prediction open = predicted("multipole-perturbation", question);
  if (open.stroke.area() != 0) {
    const double as_open = open.velocity * best.stroke.area() / open.stroke.area();
    known.cancellation = std::max(1.0, std::abs(as_open / best.velocity) * (1 + known.uncertainty.velocity));
  }
  return known;
}

// Steps: docs/method/mobility-swarms.md, 3.3e-5 of the velocity with 100 a cycle, of third order.
ErrorEstimate mobility_error(const Question& question, const BestKnown& best, MobilityModel model,
                             int steps_per_cycle) {
  const Numbers numbers =
      question.box ? in_box(question, method_of(model)) : numbers_of(predicted(method_of(model), question));
  ErrorEstimate error = best.uncertainty;
  const double by_steps = 3.3e-5 * std::pow(100.0 / steps_per_cycle, 3);
  if (best.swims) error.velocity += relative(numbers.velocity, best.velocity) + by_steps;
  for (int arm = 0; arm < 2; ++arm)
    error.arm_amplitudes[arm] += relative(numbers.arm_amplitudes[arm], best.arm_amplitudes[arm]);
  return error;
}

ErrorEstimate lattice_error(const LatticeLag& lattice, const std::optional<BestKnown>& best,
                            const ResolvedRun& run) {
  const LagErrors lag = lattice.errors(run.timing);
  const double swing =
      best ? std::min(best->arm_amplitudes[0], best->arm_amplitudes[1]) / run.cell : INFINITY;
  const ErrorEstimate cells = error_of_cells(run.cells_per_radius, run.scheme, swing);
  const ErrorEstimate gaps = error_of_gaps(run.smallest_gap, best ? best->nearest / run.cell : 0);
  const double cancellation = best ? best->cancellation : 1, compression = run.mach * run.mach;
  ErrorEstimate error;
  if (!best || best->swims) {
    error.velocity =
        std::hypot(lag.velocity + cancellation * (cells.velocity + gaps.velocity) + compression, least_known);
  }
  for (int arm = 0; arm < 2; ++arm) {
    if (best && best->arm_amplitudes[arm] == 0) continue;  // at rest
    error.arm_amplitudes[arm] =
        std::hypot(std::abs(lag.arm_amplitudes[arm]) + cells.arm_amplitudes[arm] + gaps.arm_amplitudes[arm],
                   least_known);
  }
  return error;
}

}  // namespace beadswim
