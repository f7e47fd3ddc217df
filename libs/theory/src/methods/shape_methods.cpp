#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

/// Returns the value of the setting "fluid".
std::string fluid_name(const ShapedSwimmer& swimmer) {
  return fmt::format("{}{}", swimmer.half_space ? "half-space" : "unbounded",
                     swimmer.flow.is_zero() ? "" : ", with background flow");
}

/// Returns the surroundings of the swimmer for the validity of a prediction.
std::string surroundings_of(const ShapeQuestion& question) {
  const ShapedSwimmer& swimmer = question.swimmer;
  std::string text = fluid_name(swimmer);
  if (const auto& half_space = swimmer.half_space)
    text += fmt::format(", at the height {:.6g} over the no-slip wall",
                        half_space->height(swimmer.place) * question.units.length);
  if (swimmer.is_held()) text += ", moved back to its place and orientation after each cycle";
  return text;
}

Prediction prediction_from(const ShapeQuestion& question, const BeadMobility& mobility,
                           const ShapeMotion& motion, const std::string& amplitude) {
  const ShapedSwimmer& swimmer = question.swimmer;
  const Vec3 axis = swimmer.orientation.col(0);
  std::vector<double> rest_lengths;
  for (const Bond& bond : swimmer.type.bonds) rest_lengths.push_back(bond.rest_length);
  Prediction prediction = prediction_from(motion, rest_lengths);
  prediction.velocity_vector = motion.velocity_vector;
  prediction.angular_velocity = motion.angular_velocity;
  prediction.power = motion.power;
  ShapedSwimmer in_open_space = swimmer;  // as the efficiency of runs
  in_open_space.half_space.reset();
  const double drag = towing_drag(in_open_space, motion.mean_shape, axis, mobility.tensors);
  prediction.efficiency = lighthill_efficiency(drag, prediction.velocity, motion.power);
  const double omega = 2 * std::numbers::pi / swimmer.type.driving.period;
  const double depth = std::sqrt(2 * swimmer.viscosity / (question.fluid_density * omega));
  const double radius = std::ranges::max(swimmer.type.beads, {}, &Bead::radius).radius;
  prediction.validity = fmt::format(
      "{} pairs; {}; alone; fluid: {}; no inertia of fluid or beads (penetration depth {:.2f} radii); "
      "the error for this shape is not known",
      mobility.name, amplitude, surroundings_of(question), depth / radius);
  prediction.settings = {{"mobility", mobility.name},
                         {"fluid", fluid_name(swimmer)},
                         {"period", swimmer.type.driving.period},
                         {"towing_drag", drag}};
  if (std::isfinite(motion.smallest_gap))
    prediction.settings.emplace_back("smallest_gap_over_radius", motion.smallest_gap / radius);
  if (motion.smallest_gap < 0)
    mark_unusable(prediction, swimmer.half_space ? "in this motion beads would overlap, or the wall"
                                                 : "in this motion the beads would overlap");
  return prediction;
}

}  // namespace

Prediction predict_shape_perturbation(const BeadMobility& mobility, const ShapeQuestion& question) {
  return prediction_from(question, mobility, second_order_motion(question.swimmer, mobility.tensors),
                         "second order in amplitude");
}

Prediction predict_shape_ode(const BeadMobility& mobility, const ShapeQuestion& question) {
  const ShapeMotion motion = periodic_motion(question.swimmer, mobility.tensors);
  Prediction prediction = prediction_from(question, mobility, motion, "periodic motion at finite amplitude");
  prediction.settings.emplace_back("steps_per_period", static_cast<double>(motion.samples));
  prediction.settings.emplace_back("numerical_error", motion.numerical_error);
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
