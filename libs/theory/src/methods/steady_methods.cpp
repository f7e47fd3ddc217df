#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

// Predictions without inertia for three beads on a line: to second order in amplitude, and at finite
// amplitude.

namespace beadswim {

namespace {

constexpr const char* exact_flow = "exact Stokes flow of three spheres (axisymmetric multipoles)";

/// Returns the swimmer of another shape in its box.
ShapedSwimmer shape_in_box(const Question& question) {
  const auto& [box, place] = *question.surroundings.box;
  ShapedSwimmer swimmer = question.shape();
  swimmer.domain.box = box;
  swimmer.place = Vec3(place[0], place[1], place[2]);
  return swimmer;
}

MobilityFunction mobility_in_box(const Question& question) {
  return [&swimmer = question.line(),
          flow = box_line_flow(*question.surroundings.box, question.line().viscosity)](
             const LinePositions& x) { return rotne_prager_mobility(flow, swimmer, x); };
}

/// Adds the validity, the uncertainty and the settings that the methods rpy-box-perturbation and rpy-box-ode
/// share. `second_order`: velocity in the box to second order in amplitude [length/time].
void add_box_limits(const Question& question, double second_order, Prediction& prediction) {
  const CollinearSwimmer& swimmer = question.line();
  const double unbounded = second_order_motion(swimmer, rest_mobility(swimmer, rotne_prager)).velocity;
  const std::optional<double> exact = exact_velocity(question);
  prediction.validity = fmt::format(
      "Rotne-Prager pairs with all images in the layout's box; unbounded pairs of this swimmer are {}; no "
      "inertia, which screens images (penetration depth {:.2f} arms)",
      distance_from_exact(question, unbounded, exact), penetration_depth_over_arm(question));
  prediction.settings.emplace_back("mobility", "Rotne-Prager");
  prediction.settings.emplace_back(
      "fluid", "box: " + box_text(question.surroundings.box->box, question.units().length));
  if (exact) prediction.settings.emplace_back("velocity_over_unbounded", second_order / unbounded);
  add_driving_settings(question, prediction);
  prediction.uncertainty = relative_uncertainty(unbounded, exact, 0);
}

/// Returns the relative uncertainty of a velocity with exact mobilities; nullopt if the velocity is roundoff.
std::optional<double> numerical_uncertainty(const Question& question, const PeriodicMotion& motion) {
  constexpr double series_error = 1e-8;        // of multipole series and harmonic balance
  constexpr double velocity_roundoff = 1e-12;  // relative to the speed of the arms
  if (!exact_velocity(question)) return std::nullopt;
  return series_error + velocity_roundoff * question.line().angular_frequency() *
                            std::ranges::max(motion.stroke.amplitude) / std::abs(motion.velocity);
}

}  // namespace

std::string box_text(const Box& box, double unit) {
  const auto axis = [&](int i) {
    return fmt::format("{} {:.6g}", to_text(box.boundary[i]), box.lengths[i] * unit);
  };
  return axis(0) + ", " + axis(1) + ", " + axis(2);
}

std::string shape_perturbation_obstacle(const Question& question) {
  return second_order_obstacle(question.shape());
}

std::string shape_moments_obstacle(const Question& question) {
  if (question.shape().flow.is_zero()) return {};
  return "this method neglects that beads resist the strain of a flow; use rpy-ode";
}

std::string shape_box_obstacle(const Question& question) {
  if (!question.surroundings.box && question.surroundings.obstacle.empty())
    return "this method needs a box, but the fluid of the layout is unbounded; use the method "
           "rpy-perturbation or rpy-ode";
  return question.surroundings.obstacle;
}

std::string overlap_obstacle(const Question& question) {
  const CollinearSwimmer& swimmer = question.line();
  if (smallest_gap(swimmer, rest_positions(swimmer)) >= 0) return {};
  const double unit = question.units().length;
  return fmt::format(
      "beads overlap at rest: arms {:.6g}, {:.6g} with radii {:.6g}, {:.6g}, {:.6g}; each arm must be longer "
      "than the sum of the radii at its ends",
      swimmer.arm[0] * unit, swimmer.arm[1] * unit, swimmer.radius[0] * unit, swimmer.radius[1] * unit,
      swimmer.radius[2] * unit);
}

std::string image_overlap_obstacle(const Question& question) {
  const auto& box = question.surroundings.box;
  if (!box || smallest_gap_in_box(question.line(), *box) >= 0) return {};
  return fmt::format(
      "beads at rest overlap images of beads or walls of the box ({}, the first axis along the "
      "swimmer); make the box longer or wider, or move the swimmer",
      box_text(box->box, question.units().length));
}

std::string exact_obstacle(const Question& question) {
  if (std::string obstacle = overlap_obstacle(question); !obstacle.empty()) return obstacle;
  if (question.exact()) return {};
  return fmt::format(
      "exact Stokes flow is not known for this swimmer (separation ratio l/lambda = {:.5g}): {}; use the "
      "less accurate method rpy-perturbation",
      separation_ratio(question.line()), reason_against([&] { *question.exact(); }));
}

std::string box_obstacle(const Question& question) {
  if (std::string obstacle = overlap_obstacle(question); !obstacle.empty()) return obstacle;
  if (std::string obstacle = shape_box_obstacle(question); !obstacle.empty()) return obstacle;
  return image_overlap_obstacle(question);
}

Prediction predict_perturbation(const BeadMobility& mobility, const Question& question) {
  if (!question.is_line()) return predict_shape_perturbation(mobility, question.shape(), question);
  const CollinearSwimmer& swimmer = question.line();
  const bool is_exact = &mobility == &exact_beads;
  const PeriodicMotion motion =
      is_exact ? question.exact()->motion
               : second_order_motion(swimmer, mobility.on_line(swimmer, rest_positions(swimmer)));
  Prediction prediction = prediction_from(motion, swimmer.arm);
  const std::optional<double> exact = exact_velocity(question);
  if (question.exact())
    prediction.uncertainty = relative_uncertainty(motion.velocity, exact, question.exact()->amplitude_change);
  prediction.validity = is_exact ? exact_flow
                                 : fmt::format("{} pairs, no truncation in lambda/l: here {}", mobility.name,
                                               distance_from_exact(question, motion.velocity, exact));
  prediction.settings.emplace_back("mobility", mobility.name);
  add_common_limits(question, prediction);
  return prediction;
}

Prediction predict_ode(const BeadMobility& mobility, const Question& question) {
  if (!question.is_line()) return predict_shape_ode(mobility, question.shape(), question);
  const CollinearSwimmer& swimmer = question.line();
  const LinePositions rest = rest_positions(swimmer);
  const bool is_exact = &mobility == &exact_beads;
  const PeriodicMotion motion =
      is_exact ? *question.finite() : periodic_motion(swimmer, rest, [&](const LinePositions& x) {
        return mobility.on_line(swimmer, x);
      });
  Prediction prediction = prediction_from(motion, swimmer.arm);
  if (is_exact) {
    prediction.uncertainty = numerical_uncertainty(question, motion);
    prediction.validity = exact_flow;
  } else {
    const double second_order = second_order_motion(swimmer, mobility.on_line(swimmer, rest)).velocity;
    const std::optional<double> exact = exact_velocity(question);
    prediction.uncertainty = relative_uncertainty(second_order, exact, 0);
    prediction.validity = fmt::format("{} pairs: at small amplitude here {}", mobility.name,
                                      distance_from_exact(question, second_order, exact));
  }
  prediction.validity += fmt::format(
      "; periodic motion at finite amplitude; alone in unbounded fluid; no inertia of fluid or beads "
      "(penetration depth {:.2f} arms)",
      penetration_depth_over_arm(question));
  prediction.settings = {{"smallest_gap_over_radius", motion.smallest_gap / swimmer.radius[1]},
                         {"harmonics", static_cast<double>(motion.samples - 1) / 2},
                         {"mobility", mobility.name},
                         {"fluid", "unbounded"}};
  add_driving_settings(question, prediction);
  return prediction;
}

Prediction predict_box_perturbation(const BeadMobility& beads, const Question& question) {
  if (!question.is_line()) return predict_shape_perturbation(beads, shape_in_box(question), question);
  const CollinearSwimmer& swimmer = question.line();
  const CollinearMobility at_rest =
      mobility_in_box(question)(rest_positions(swimmer, *question.surroundings.box));
  const PeriodicMotion motion = second_order_motion(swimmer, at_rest);
  Prediction prediction = prediction_from(motion, swimmer.arm);
  add_box_limits(question, motion.velocity, prediction);
  if (question.exact() && prediction.uncertainty) {
    prediction.uncertainty = std::hypot(*prediction.uncertainty, question.exact()->amplitude_change);
    add_amplitude_limit(question, prediction);
  }
  mark_unusable_if_beads_touch(question, prediction);
  return prediction;
}

Prediction predict_box_ode(const BeadMobility& beads, const Question& question) {
  if (!question.is_line()) return predict_shape_ode(beads, shape_in_box(question), question);
  const CollinearSwimmer& swimmer = question.line();
  const LinePositions rest = rest_positions(swimmer, *question.surroundings.box);
  const MobilityFunction mobility = mobility_in_box(question);
  const PeriodicMotion motion = periodic_motion(swimmer, rest, mobility);
  Prediction prediction = prediction_from(motion, swimmer.arm);
  add_box_limits(question, second_order_motion(swimmer, mobility(rest)).velocity, prediction);
  prediction.validity += "; periodic motion at finite amplitude";
  return prediction;
}

double min_exact_gap(const CollinearSwimmer& swimmer) {
  constexpr double min_gap_over_radius = 0.02;  // where the multipole series needs fewer than 200 terms
  return min_gap_over_radius * *std::ranges::min_element(swimmer.radius);
}

PeriodicMotion exact_periodic_motion(const CollinearSwimmer& swimmer) {
  constexpr double tolerance = 1e-10;  // requested error of mobilities; actual errors are 1000 times smaller
  const MobilityFunction mobility = [&](const LinePositions& x) {
    return exact_mobility(swimmer, x, tolerance);
  };
  return periodic_motion(swimmer, rest_positions(swimmer), mobility, min_exact_gap(swimmer));
}

}  // namespace beadswim
