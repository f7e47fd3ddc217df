#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

/// Returns the value of the setting "fluid".
std::string fluid_name(const ShapedSwimmer& swimmer, double unit) {
  if (swimmer.domain.box) return "box: " + box_text(*swimmer.domain.box, unit);
  return fmt::format("{}{}", swimmer.domain.half_space ? "half-space" : "unbounded",
                     swimmer.flow.is_zero() ? "" : ", with background flow");
}

/// Returns the surroundings of the swimmer for the validity of a prediction.
std::string surroundings_text(const ShapedSwimmer& swimmer, double unit) {
  std::string text = fluid_name(swimmer, unit);
  if (const auto& half_space = swimmer.domain.half_space)
    text +=
        fmt::format(", at the height {:.6g} over the no-slip wall", half_space->height(swimmer.place) * unit);
  if (swimmer.is_held()) text += ", moved back to its place and orientation after each cycle";
  return text;
}

bool is_exact(const BeadMobility& mobility) {
  return &mobility == &exact_beads;
}

/// Returns the estimated relative error of the velocity in open space or over a wall, at small amplitude: the
/// difference from the velocity with force moments up to order 2, plus the error of the latter. Returns
/// nullopt if it is not known.
std::optional<double> error_of_mobility(const Question& question, const BeadMobility& mobility) {
  if (!question.reference() || question.reference()->velocity.isZero(0)) return std::nullopt;
  const auto& [velocity, error] = *question.reference();
  const ShapedSwimmer& swimmer = question.shape();
  const double difference =
      is_exact(mobility)
          ? 0
          : (second_order_motion(swimmer, mobility.of_shape(swimmer)).velocity_vector - velocity).norm();
  return (difference + error) / velocity.norm();
}

Prediction prediction_from(const ShapedSwimmer& swimmer, const Question& question,
                           const BeadMobility& mobility, const ShapeMotion& motion,
                           const std::string& amplitude) {
  std::vector<double> rest_lengths;
  for (const Bond& bond : swimmer.type.bonds) rest_lengths.push_back(bond.rest_length);
  Prediction prediction = prediction_from(motion, rest_lengths);
  prediction.velocity_vector = motion.velocity_vector;
  prediction.angular_velocity = motion.angular_velocity;
  prediction.power = motion.power;
  ShapedSwimmer in_open_space = swimmer;  // as the efficiency of runs
  in_open_space.domain = {};
  const double drag = towing_drag(motion.mean_shape, motion.axis, mobility.of_shape(in_open_space));
  prediction.efficiency = lighthill_efficiency(drag, prediction.velocity, motion.power);
  const double omega = 2 * std::numbers::pi / swimmer.type.driving.period;
  const double depth = std::sqrt(2 * swimmer.viscosity / (question.fluid_density() * omega));
  const double radius = std::ranges::max(swimmer.type.beads, {}, &Bead::radius).radius;
  const std::string hydrodynamics =
      is_exact(mobility) ? "force moments up to order 2" : fmt::format("{} pairs", mobility.name);
  const double unit = question.units().length;
  prediction.validity =
      fmt::format("{}; {}; alone; fluid: {}; no inertia of fluid or beads (penetration depth {:.2f} radii); ",
                  hydrodynamics, amplitude, surroundings_text(swimmer, unit), depth / radius);
  prediction.settings = {{"mobility", is_exact(mobility) ? hydrodynamics : mobility.name},
                         {"fluid", fluid_name(swimmer, unit)},
                         {"period", swimmer.type.driving.period},
                         {"towing_drag", drag}};
  if (std::isfinite(motion.smallest_gap))
    prediction.settings.emplace_back("smallest_gap_over_radius", motion.smallest_gap / radius);
  if (motion.smallest_gap < 0)
    mark_unusable(prediction, swimmer.domain.half_space || swimmer.domain.box
                                  ? "in this motion beads would overlap, or the wall"
                                  : "in this motion the beads would overlap");
  return prediction;
}

}  // namespace

ShapeReference shape_reference(const ShapedSwimmer& swimmer) {
  const auto motion = [&](int order) {
    return second_order_motion(swimmer, moment_mobility(swimmer, order));
  };
  const ShapeMotion best = motion(2);
  constexpr double roundoff = 1e-5;  // of differences that give the second order
  double swing = 0;
  for (const double amplitude : best.stroke.amplitude) swing = std::max(swing, amplitude);
  const double reach = best.mean_shape.colwise().norm().maxCoeff();
  const double scale = 2 * std::numbers::pi / swimmer.type.driving.period * swing * swing / reach;
  if (best.velocity_vector.norm() < roundoff * scale) return {};
  return {.velocity = best.velocity_vector,
          .error = (best.velocity_vector - motion(1).velocity_vector).norm()};
}

Prediction predict_shape_perturbation(const BeadMobility& mobility, const ShapedSwimmer& swimmer,
                                      const Question& question) {
  Prediction prediction =
      prediction_from(swimmer, question, mobility, second_order_motion(swimmer, mobility.of_shape(swimmer)),
                      "second order in amplitude");
  prediction.validity += "the error for this shape is not known";
  return prediction;
}

Prediction predict_shape_ode(const BeadMobility& mobility, const ShapedSwimmer& swimmer,
                             const Question& question) {
  const ShapeMotion motion = periodic_motion(swimmer, mobility.of_shape(swimmer));
  Prediction prediction =
      prediction_from(swimmer, question, mobility, motion, "periodic motion at finite amplitude");
  prediction.uncertainty = error_of_mobility(question, mobility);
  prediction.validity +=
      prediction.uncertainty
          ? fmt::format(
                "the uncertainty is the error of this mobility at small amplitude{}, estimated with "
                "force moments of orders 1 and 2, and validated for three beads on a line only",
                swimmer.domain.box ? " without the box" : "")
          : "the error for this shape is not known";
  prediction.settings.emplace_back("steps_per_period", static_cast<double>(motion.samples));
  if (std::isfinite(motion.numerical_error))
    prediction.settings.emplace_back("numerical_error", motion.numerical_error);
  if (!motion.is_resolved)
    mark_unusable(prediction, "the time steps are too long for this motion, and its velocity may be wrong");
  constexpr double visible = 1e-6;
  if (motion.turn > visible) {
    prediction.validity += fmt::format(
        "; the drives turn the swimmer by {:.3g} rad from its orientation at the start until its motion is "
        "periodic",
        motion.turn);
    prediction.settings.emplace_back("turn", motion.turn);
  }
  return prediction;
}

}  // namespace beadswim
