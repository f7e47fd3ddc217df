#include <fmt/core.h>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "beadswim/theory/periodic_motion.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

/// Returns boundary and length of each axis, such as "periodic 128, periodic 80, periodic 80", with the
/// swimmer's axis first.
std::string box_text(const Box& box, double unit) {
  const auto axis = [&](int i) {
    return fmt::format("{} {:.6g}", to_text(box.boundary[i]), box.lengths[i] * unit);
  };
  return axis(0) + ", " + axis(1) + ", " + axis(2);
}

/// Adds the validity, the uncertainty and the settings that the methods rpy-box-perturbation and rpy-box-ode
/// share. `second_order`: velocity in the box to second order in amplitude [length/time].
void add_limits(const Question& question, double second_order, Prediction& prediction) {
  const CollinearSwimmer& swimmer = question.swimmer;
  const double unbounded = second_order_motion(swimmer, rest_mobility(swimmer, rotne_prager)).velocity;
  const std::optional<double> exact = exact_velocity(question);
  prediction.validity = fmt::format(
      "Rotne-Prager pairs with all images in the layout's box; unbounded pairs of this swimmer are {}; no "
      "inertia, which screens images (penetration depth {:.2f} arms)",
      distance_from_exact(question, unbounded, exact), penetration_depth_over_arm(question));
  prediction.settings.emplace_back("mobility", "Rotne-Prager");
  prediction.settings.emplace_back("fluid", "box: " + box_text(question.box->box, question.units.length));
  if (exact) prediction.settings.emplace_back("velocity_over_unbounded", second_order / unbounded);
  add_driving_settings(question, prediction);
  prediction.uncertainty = relative_uncertainty(unbounded, exact, 0);
}

}  // namespace

std::optional<std::string> box_obstacle(const Question& question) {
  if (auto obstacle = overlap_obstacle(question)) return obstacle;
  if (!question.box_obstacle.empty()) return question.box_obstacle;
  if (!question.box)
    return "this method needs a box, but the fluid of the layout is unbounded; use the method "
           "rpy-perturbation or rpy-ode";
  return image_overlap(question.swimmer, *question.box);
}

Prediction predict_rpy_box_perturbation(const Question& question) {
  const CollinearSwimmer& swimmer = question.swimmer;
  const LineFlow flow = box_line_flow(*question.box, swimmer.viscosity);
  const SecondOrderMotion motion = second_order_motion(
      swimmer, rotne_prager_mobility(flow, swimmer, rest_positions(swimmer, *question.box)));
  Prediction prediction = prediction_from(swimmer, motion);
  add_limits(question, motion.velocity, prediction);
  if (question.exact && prediction.uncertainty) {
    prediction.uncertainty = std::hypot(*prediction.uncertainty, question.exact->amplitude_change);
    add_amplitude_limit(question, prediction);
  }
  mark_unusable_if_beads_touch(question, prediction);
  return prediction;
}

Prediction predict_rpy_box_ode(const Question& question) {
  const CollinearSwimmer& swimmer = question.swimmer;
  const LineFlow flow = box_line_flow(*question.box, swimmer.viscosity);
  const LinePositions rest = rest_positions(swimmer, *question.box);
  const MobilityFunction mobility = [&](const LinePositions& x) {
    return rotne_prager_mobility(flow, swimmer, x);
  };
  const PeriodicMotion motion = periodic_motion(swimmer, rest, mobility);
  Prediction prediction = prediction_from(motion);
  add_limits(question, second_order_motion(swimmer, mobility(rest)).velocity, prediction);
  prediction.validity += "; periodic motion at finite amplitude";
  return prediction;
}

}  // namespace beadswim
