#include "beadswim/plan/model_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "beadswim/theory/methods.hpp"

namespace beadswim {
namespace {

Prediction predicted(const char* method, const Question& question) {
  return predict(find_method(method), question);
}

MotionValues motion_of(const Prediction& prediction) {
  const std::vector<double>& arms = prediction.stroke.amplitude;
  return {prediction.velocity, arms[0], arms[1]};
}

/// Returns the motion by a mobility model in the question's box. No method treats all models in a box. The
/// motion by Rotne-Prager theory (RP) in the box is therefore corrected by the difference between the model
/// and RP in open space:
///   velocity   v_RP,box + (v_model - v_RP) A_box/A
///   amplitude  d_RP,box d_model/d_RP
/// A = d_1 d_2 sin(beta) is the stroke area by RP, with the arm amplitudes d_1, d_2 and the phase shift beta.
MotionValues motion_in_box(const Question& question, const char* method_in_open_space) {
  const Prediction pairs_in_box = predicted("rpy-box-ode", question);
  const Prediction pairs = predicted("rpy-ode", question), model = predicted(method_in_open_space, question);
  const double area = pairs.stroke.area() != 0 ? pairs_in_box.stroke.area() / pairs.stroke.area() : 1;
  MotionValues motion = motion_of(pairs_in_box);
  motion[0] += (model.velocity - pairs.velocity) * area;
  for (int arm = 0; arm < 2; ++arm) {
    if (pairs.stroke.amplitude[arm] > 0)
      motion[1 + arm] *= model.stroke.amplitude[arm] / pairs.stroke.amplitude[arm];
  }
  return motion;
}

/// Returns true if the model neglects everything about the size of beads that Rotne-Prager theory neglects.
bool is_rotne_prager(MobilityModel model, const MobilitySettings& settings) {
  return model == MobilityModel::rpy || (has_moment_order(model) && settings.multipole_order == 0);
}

const char* method_of(MobilityModel model, const MobilitySettings& settings) {
  if (model == MobilityModel::oseen) return "oseen-ode";
  return is_rotne_prager(model, settings) ? "rpy-ode" : "multipole-ode";
}

/// Returns the truncation error of force moments, divided by the error of Rotne-Prager theory, both relative
/// to exact flow (docs/method/force-moments.md); 0 for other models.
double truncation(MobilityModel model, const MobilitySettings& settings) {
  if (model != MobilityModel::multipole || is_rotne_prager(model, settings)) return 0;
  return settings.multipole_order == 1 ? 0.06 : 0.025;
}

/// Error estimates below this value have not been validated, because the reference velocities of
/// docs/speed-against-error.md have uncertainties of 0.2 and 0.4 %.
constexpr double min_validated_error = 0.002;

/// Returns the difference of two motions, relative to `best`; 0 for a velocity or arm amplitude of `best`
/// that is zero.
MotionValues relative_difference(const MotionValues& a, const MotionValues& b, const BestPrediction& best) {
  MotionValues change = (best.motion != 0).select((a / best.motion - b / best.motion).abs(), 0.0);
  if (!best.is_swimming) change[0] = 0;
  return change;
}

/// Errors by a bead boundary, divided by those of the bead boundary mr: standard deviations of the velocity
/// over places within a cell, measured by docs/results/scheme-factors.sh. The exception is the wander of cli:
/// with the measured 2.7, only 33 of 37 random scenes (docs/results/stated-uncertainty.sh) are within their
/// limits, with 4 there are 36.
struct SchemeFactors {
  double cells = 1;   ///< places in all directions
  double wander = 1;  ///< places along the axis of the swimmer, off the planes of the lattice
};

SchemeFactors scheme_factors(BeadScheme scheme) {
  switch (scheme) {
    case BeadScheme::staircase:
      return {.cells = 4.7, .wander = 7.7};
    case BeadScheme::cli:
      return {.cells = 1.8, .wander = 4};
    case BeadScheme::psm:
      return {.cells = 1.8, .wander = 0.4};
    case BeadScheme::mr:
      return {};
  }
  return {};
}

/// Returns the relative error by cells of finite size, averaged over all places of the beads within cells.
/// The formulas are fits to measurements: docs/speed-against-error.md for small time steps, and
/// docs/hard-cases.md below 2 cells per radius.
ErrorRange error_of_cells(double cells_per_radius, BeadScheme scheme) {
  const double n2 = cells_per_radius * cells_per_radius, n5 = n2 * n2 * cells_per_radius;
  const double factor = scheme_factors(scheme).cells;
  const double typical_arm = factor * 0.08 / (n2 * n2), arm_limit = factor * (0.03 / n2 + 0.05 / n5);
  return {.typical = {factor * 0.027 / n2, typical_arm, typical_arm},
          .limit = {factor * 0.045 / n2, arm_limit, arm_limit}};
}

/// Returns two standard deviations of the relative velocity over all places of the beads within cells.
///
/// The mobility of a bead on the lattice depends on its place within a cell. An oscillation over several
/// cells averages this dependence, an oscillation over less than a cell does not. The formula is a fit to
/// runs with strokes of 0.15 to 5 cells (docs/resolution.md). `swing`: the smaller arm amplitude [cell].
double velocity_wander(double cells_per_radius, BeadScheme scheme, double swing, double plane_factor) {
  const double by_place = scheme == BeadScheme::psm ? 1 : plane_factor;  // psm does not wander more on planes
  const double by_swing = std::min(1 / swing, std::pow(swing, -2.5));
  return scheme_factors(scheme).wander * by_place * 0.1 / (cells_per_radius * cells_per_radius) * by_swing;
}

/// Returns the relative error that occurs because cells do not resolve gaps between beads. `at_rest`:
/// smallest gap at rest [cell]. `smallest_stroke_gap`: smallest gap during the stroke [cell]. The errors were
/// measured in the cases "contact at the start" and "driving" of docs/hard-cases.md.
MotionValues error_of_gaps(double at_rest, double smallest_stroke_gap) {
  constexpr double resolved = 2.5, unresolved_gap = 1, touching = 0.25;  // [cell]
  constexpr double max_error_at_rest = 0.25, max_error_in_stroke = 0.04;
  const double unresolved_fraction = std::clamp((resolved - at_rest) / (resolved - unresolved_gap), 0.0, 1.0);
  const double error_at_rest = max_error_at_rest * unresolved_fraction * unresolved_fraction;
  const double error_in_stroke = smallest_stroke_gap < touching ? max_error_in_stroke : 0;
  const double arm = error_at_rest / 2 + error_in_stroke;
  return {error_at_rest + error_in_stroke, arm, arm};
}

double smallest_gap_in_stroke(const CollinearSwimmer& swimmer, const Prediction& motion) {
  const std::array<double, 2> at_rest = gaps_at_rest(swimmer);
  double smallest_stroke_gap = INFINITY;
  for (int arm = 0; arm < 2; ++arm) {
    const double mean = motion.arm_means ? (*motion.arm_means)[arm] - swimmer.arm[arm] : 0;
    smallest_stroke_gap = std::min(smallest_stroke_gap, at_rest[arm] + mean - motion.stroke.amplitude[arm]);
  }
  return smallest_stroke_gap;
}

}  // namespace

double lattice_plane_factor(const Vec3& position, const Vec3& axis) {
  int along = 0;
  constexpr double parallel = 1 - 1e-6;
  if (axis.cwiseAbs().maxCoeff(&along) < parallel) return 1;
  double closeness = 1;
  for (const int across : {(along + 1) % 3, (along + 2) % 3})
    closeness *= std::pow(std::cos(2 * std::numbers::pi * position[across]), 2);
  return 1 + 4 * closeness;
}

MotionValues combined(const MotionValues& a, const MotionValues& b) {
  return a.binaryExpr(b, [](double x, double y) { return std::hypot(x, y); });
}

ErrorRange combined(const ErrorRange& a, const ErrorRange& b) {
  return {.typical = combined(a.typical, b.typical), .limit = combined(a.limit, b.limit)};
}

BestPrediction best_prediction(const Question& question) {
  const Prediction best = predicted("inertia-corrected", question);
  BestPrediction known{.motion = motion_of(best)};
  known.smallest_stroke_gap = smallest_gap_in_stroke(question.line(), best);
  known.is_swimming = best.uncertainty.has_value() && best.velocity != 0;
  if (best.stroke_uncertainty) {
    const auto& [first, second] = best.stroke_uncertainty->arm_amplitudes;
    known.uncertainty = {0, first, second};
  }
  if (!known.is_swimming) return known;
  known.uncertainty[0] = *best.uncertainty;
  const Prediction open = predicted("multipole-perturbation", question);
  if (open.stroke.area() != 0) {
    const double as_open = open.velocity * best.stroke.area() / open.stroke.area();
    known.cancellation = std::max(1.0, std::abs(as_open / best.velocity) * (1 + known.uncertainty[0]));
  }
  return known;
}

MotionValues difference(const MotionValues& motion, const BestPrediction& best) {
  return relative_difference(motion, best.motion, best);
}

// The error by time steps of finite length is 3.3e-5 of the velocity with 100 steps per cycle. It is
// proportional to the third power of the time step (docs/method/mobility-swarms.md). The tolerance E of
// mobility products changed the velocities of a single swimmer and of a swarm by up to 5 E. With memory of
// the fluid, the error by time steps is 5e-4 and proportional to the square of the time step.
double velocity_error_of_steps(MobilityModel model, const MobilitySettings& settings) {
  const double steps = settings.steps_per_cycle.value_or(MobilitySettings::default_steps_per_cycle);
  const double error_of_time_steps =
      model == MobilityModel::unsteady ? 5e-4 * std::pow(100 / steps, 2) : 3.3e-5 * std::pow(100 / steps, 3);
  return error_of_time_steps + 5 * settings.tolerance;
}

namespace {

/// Returns the error of the model unsteady. The truncation of force moments causes a share of the difference
/// between Rotne-Prager theory and exact flow, both without inertia; a further error grows with the radius a
/// over the penetration depth delta. Measured in docs/fluid-inertia.md; there errors are typically a half
/// (order 0) or a quarter of the limit.
ErrorRange unsteady_error(const Question& question, const BestPrediction& best,
                          const MobilitySettings& settings) {
  const int order = settings.multipole_order;
  const double share = std::array{1.6, 0.16, 0.05}[order], depth_factor = std::array{0.1, 0.1, 0.006}[order];
  constexpr double min_velocity_error = 0.006, min_arm_error = 0.001;
  const CollinearSwimmer& swimmer = question.line();
  const double radius = *std::ranges::max_element(swimmer.radius);
  // |alpha| is sqrt(2) over the penetration depth.
  const double over_depth = radius * std::abs(inverse_penetration_depth(swimmer, question.fluid_density()));
  const double inertia_error = depth_factor * std::pow(over_depth, 4) / 4;
  const MotionValues pairs = motion_of(predicted("rpy-ode", question)),
                     exact = motion_of(predicted("multipole-ode", question));
  MotionValues model_error = share * relative_difference(pairs, exact, best);
  MotionValues step_error = MotionValues::Zero();
  if (best.is_swimming) {
    model_error[0] += best.cancellation * (min_velocity_error + inertia_error);
    step_error[0] = velocity_error_of_steps(MobilityModel::unsteady, settings);
  }
  for (const int arm : {1, 2})
    if (best.motion[arm] > 0) model_error[arm] += min_arm_error + inertia_error;
  const double typical_share = order == 0 ? 0.5 : 0.25;
  return {.typical = typical_share * model_error + step_error, .limit = model_error + step_error};
}

}  // namespace

ErrorRange mobility_error(const Question& question, const BestPrediction& best, MobilityModel model,
                          const MobilitySettings& settings) {
  if (model == MobilityModel::unsteady) return unsteady_error(question, best, settings);
  const auto motion_by = [&](const char* method) {
    return question.surroundings.box ? motion_in_box(question, method)
                                     : motion_of(predicted(method, question));
  };
  const MotionValues motion = motion_by(method_of(model, settings));
  const MotionValues model_error = difference(motion, best);
  MotionValues step_error = MotionValues::Zero();  // by time steps and by truncation
  if (best.is_swimming) step_error[0] = velocity_error_of_steps(model, settings);
  if (const double truncated = truncation(model, settings); truncated > 0)
    step_error += truncated * relative_difference(motion_by("rpy-ode"), motion, best);
  constexpr double margin = 1.15;  // the motion of the model in a box is known to 15 % of the difference
  return {.typical = combined(model_error, 0.5 * best.uncertainty) + step_error,
          .limit = margin * model_error + best.uncertainty + step_error};
}

ErrorRange resolution_error(const LatticeLag& lattice, const std::optional<BestPrediction>& best,
                            const ResolvedRun& run) {
  const MotionValues lag = lattice.errors(run.timing).abs();
  const MotionValues gaps = error_of_gaps(run.smallest_gap, best ? best->smallest_stroke_gap / run.cell : 0);
  const MotionValues factor{best ? best->cancellation : 1, 1, 1}, compression{run.mach * run.mach, 0, 0};
  Eigen::Array<bool, 3, 1> moves{true, true, true};  // false: no error where nothing moves
  if (best) moves = {best->is_swimming, best->motion[1] != 0, best->motion[2] != 0};
  const auto estimate = [&](const MotionValues& cells, double smallest) -> MotionValues {
    const MotionValues error = lag + factor * (cells + gaps) + compression;
    return moves.select(combined(error, MotionValues::Constant(smallest)), 0.0);
  };
  const ErrorRange cells = error_of_cells(run.cells_per_radius, run.scheme);
  return {.typical = estimate(cells.typical, 0), .limit = estimate(cells.limit, min_validated_error)};
}

ErrorRange wander_error(const std::optional<BestPrediction>& best, const ResolvedRun& run) {
  if (!best || !best->is_swimming) return {};
  const double swing = best->motion.tail<2>().minCoeff() / run.cell;
  const MotionValues limit{
      best->cancellation * velocity_wander(run.cells_per_radius, run.scheme, swing, run.plane_factor), 0, 0};
  return {.typical = 0.5 * limit, .limit = limit};
}

}  // namespace beadswim
