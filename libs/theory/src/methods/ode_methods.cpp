#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "beadswim/theory/periodic_motion.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

Prediction make_prediction(const Question& question, const PeriodicMotion& motion) {
  Prediction prediction = prediction_from(motion);
  prediction.settings.emplace_back("smallest_gap_over_radius",
                                   motion.smallest_gap / question.swimmer.radius[1]);
  prediction.settings.emplace_back("harmonics", static_cast<double>(motion.nodes - 1) / 2);
  return prediction;
}

/// Adds validity and settings of methods at finite amplitude, without inertia and in open space.
void add_limits(const Question& question, Prediction& prediction) {
  prediction.validity += fmt::format(
      "; periodic motion at finite amplitude; alone in unbounded fluid; no inertia of fluid or beads "
      "(penetration depth {:.2f} arms)",
      penetration_depth_over_arm(question));
  prediction.settings.emplace_back("fluid", "unbounded");
  add_driving_settings(question, prediction);
}

}  // namespace

Prediction predict_pair_ode(const BeadMobility& bead_mobility, const Question& question) {
  const PairLaw law = bead_mobility.pairs;
  const CollinearSwimmer& swimmer = question.swimmer;
  const MobilityFunction mobility = [&](const LinePositions& x) {
    return pairwise_mobility(law, swimmer.radius, x, swimmer.viscosity);
  };
  Prediction prediction =
      make_prediction(question, periodic_motion(swimmer, rest_positions(swimmer), mobility));
  const double second_order = second_order_motion(swimmer, rest_mobility(swimmer, law)).velocity;
  const std::optional<double> exact = exact_velocity(question);
  prediction.uncertainty = relative_uncertainty(second_order, exact, 0);
  prediction.validity = fmt::format("{} pairs: at small amplitude here {}", bead_mobility.name,
                                    distance_from_exact(question, second_order, exact));
  prediction.settings.emplace_back("mobility", bead_mobility.name);
  add_limits(question, prediction);
  return prediction;
}

double min_exact_gap(const CollinearSwimmer& swimmer) {
  constexpr double min_gap_over_radius = 0.02;  // where the multipole series needs fewer than 200 terms
  return min_gap_over_radius * *std::min_element(swimmer.radius.begin(), swimmer.radius.end());
}

PeriodicMotion exact_periodic_motion(const CollinearSwimmer& swimmer) {
  constexpr double tolerance = 1e-10;  // requested error of mobilities; actual errors are 1000 times smaller
  const MobilityFunction mobility = [&](const LinePositions& x) {
    return exact_mobility(swimmer, x, tolerance);
  };
  return periodic_motion(swimmer, rest_positions(swimmer), mobility, min_exact_gap(swimmer));
}

Prediction predict_multipole_ode(const Question& question) {
  const CollinearSwimmer& swimmer = question.swimmer;
  const PeriodicMotion motion = finite_motion(question);
  Prediction prediction = make_prediction(question, motion);
  constexpr double series_error = 1e-8;        // of multipole series and harmonic balance
  constexpr double velocity_roundoff = 1e-12;  // relative to the speed of the arms
  if (exact_velocity(question))
    prediction.uncertainty = series_error + velocity_roundoff * swimmer.angular_frequency() *
                                                std::ranges::max(motion.stroke.amplitude) /
                                                std::abs(motion.velocity);
  prediction.validity = "exact Stokes flow of three spheres (axisymmetric multipoles)";
  prediction.settings.emplace_back("mobility", "exact");
  add_limits(question, prediction);
  return prediction;
}

}  // namespace beadswim
