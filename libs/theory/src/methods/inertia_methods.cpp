#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/setting.hpp"
#include "beadswim/theory/box_mobility.hpp"
#include "beadswim/theory/inertia_corrected.hpp"
#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/reynolds_stress.hpp"
#include "beadswim/theory/unsteady_multipole.hpp"
#include "confidence.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

/// Returns a message if a bead is so large, relative to the penetration depth, that exp(kappa) overflows.
/// kappa: bead radius times |alpha| (inverse_penetration_depth).
std::string penetration_depth_obstacle(const Question& question) {
  constexpr double largest_kappa = 200;
  const CollinearSwimmer& swimmer = question.line();
  const double largest = *std::max_element(swimmer.radius.begin(), swimmer.radius.end());
  const double kappa = std::abs(inverse_penetration_depth(swimmer, question.fluid_density())) * largest;
  if (kappa < largest_kappa) return {};
  return fmt::format(
      "the penetration depth is {:.3g} times smaller than the largest bead radius, above the limit of {:.3g} "
      "times; increase {} or {}",
      kappa / std::sqrt(2.0), largest_kappa / std::sqrt(2.0), Setting::period, Setting::viscosity);
}

std::string surroundings(const Question& question) {
  return question.surroundings.box ? "the layout's box" : "unbounded";
}

void add_settings(const Question& question, Prediction& prediction) {
  prediction.settings.emplace_back("fluid", surroundings(question));
  add_driving_settings(question, prediction);
}

/// Returns the relative uncertainty of the velocity by the method unsteady-response. It combines
///   - the relative error of the velocity by steady Rotne-Prager mobility,
///   - the same relative error for the change of the velocity by inertia,
///   - the contribution of the volume of the beads to the velocity V_R by the Reynolds stress,
///   - the relative change of the velocity at finite amplitude.
std::optional<double> pair_uncertainty(const Question& question, double quasi_static, double velocity,
                                       double within_beads) {
  const std::optional<double> exact = exact_velocity(question);
  if (!exact) return std::nullopt;
  const double pair_error = std::abs(quasi_static / *exact - 1),
               inertial = std::abs(velocity / quasi_static - 1);
  return std::hypot(pair_error * (1 + inertial) + std::abs(within_beads / velocity),
                    question.exact()->amplitude_change);
}

}  // namespace

std::string inertia_obstacle(const Question& question) {
  if (std::string obstacle = overlap_obstacle(question); !obstacle.empty()) return obstacle;
  if (!question.surroundings.obstacle.empty()) return question.surroundings.obstacle;
  if (std::string obstacle = image_overlap_obstacle(question); !obstacle.empty()) return obstacle;
  return penetration_depth_obstacle(question);
}

std::string unsteady_multipole_obstacle(const Question& question) {
  if (std::string obstacle = exact_obstacle(question); !obstacle.empty()) return obstacle;
  if (std::string obstacle = penetration_depth_obstacle(question); !obstacle.empty()) return obstacle;
  if (sufficient_resolution(question.line())) return {};
  return fmt::format(
      "beads nearly touch at rest (separation ratio l/lambda = {:.5g}), and the flow would need more than "
      "100 multipoles per bead; use the less accurate method unsteady-response",
      separation_ratio(question.line()));
}

std::string inertia_corrected_obstacle(const Question& question) {
  if (std::string obstacle = unsteady_multipole_obstacle(question); !obstacle.empty()) return obstacle;
  return inertia_obstacle(question);
}

Prediction predict_unsteady_multipole(const Question& question) {
  const CollinearSwimmer& swimmer = question.line();
  const ExactInertia& exact = *question.inertia();
  const auto& [response, motion] = exact.motion;

  Prediction prediction = prediction_from({.velocity = motion.velocity(),
                                           .stroke = stroke_of(response.arm),
                                           .arm_changes = {motion.arm_changes[0], motion.arm_changes[1]}},
                                          swimmer.arm);
  const double gross = std::abs(motion.by_drift) + std::abs(motion.by_reynolds_stress);
  constexpr double roundoff = 1e-12;
  if (std::abs(motion.velocity()) > roundoff * gross) {
    const double by_amplitude = question.exact()->amplitude_change * question.exact()->motion.velocity;
    const double uncertainty = exact.numerical_error + std::abs(by_amplitude) +
                               amplitude_uncertainty(question, exact.motion, by_amplitude);
    prediction.uncertainty = uncertainty / std::abs(motion.velocity());
  }
  prediction.validity =
      "exact unsteady Stokes flow of three spheres with beads' and fluid's inertia (axisymmetric "
      "multipoles), alone in unbounded fluid, with Lagrangian drift and Reynolds stress";
  add_amplitude_limit(question, prediction);
  mark_unusable_if_beads_touch(question, prediction);
  prediction.settings.emplace_back("mobility", "exact, unsteady");
  prediction.settings.emplace_back("velocity_by_drift", motion.by_drift);
  prediction.settings.emplace_back("velocity_by_reynolds_stress", motion.by_reynolds_stress);
  prediction.settings.emplace_back("numerical_error", exact.numerical_error);
  prediction.settings.emplace_back("fluid", "unbounded");
  add_driving_settings(question, prediction);
  return prediction;
}

Prediction predict_unsteady_response(const Question& question) {
  const InertialScene scene = inertial_scene(question);
  const LinearResponse response = linear_response(question.line(), unsteady_mobility(scene));
  const double drift = lagrangian_drift(scene, response);
  const ReynoldsForm form = reynolds_form(scene);
  const Eigen::Vector3cd force = induced_forces(scene, response);
  const double reynolds = reynolds_stress_velocity(form.total, force);
  const double quasi_static =
      second_order_motion(question.line(), rest_mobility(question.line(), rotne_prager)).velocity;

  Prediction prediction;
  prediction.velocity = drift + reynolds;
  prediction.stroke = stroke_of(response.arm);
  prediction.sin_phase_shift = prediction.stroke.sin_phase_shift();
  const std::optional<double> exact = exact_velocity(question);
  prediction.uncertainty = pair_uncertainty(question, quasi_static, prediction.velocity,
                                            reynolds_stress_velocity(form.inside, force));
  prediction.validity = fmt::format(
      "unsteady Stokes flow with beads' and fluid's inertia, unsteady Faxen pairs, {}; second order in "
      "amplitude with Lagrangian drift and Reynolds stress{}; its pairs without inertia are {}",
      surroundings(question), question.surroundings.box ? " (that without images)" : "",
      distance_from_exact(question, quasi_static, exact));
  mark_unusable_if_beads_touch(question, prediction);
  prediction.settings.emplace_back("mobility", "unsteady Faxen");
  prediction.settings.emplace_back("velocity_by_drift", drift);
  prediction.settings.emplace_back("velocity_by_reynolds_stress", reynolds);
  add_settings(question, prediction);
  return prediction;
}

Prediction predict_inertia_corrected(const Question& question) {
  const InertiaCorrected best = inertia_corrected(question);
  const InertialVelocity& v = best.velocity;
  Prediction prediction;
  prediction.velocity = v.sum();
  constexpr double roundoff = 1e-12;
  const double gross = std::abs(v.quasi_static) + std::abs(v.by_stroke) + std::abs(v.by_drift);
  if (std::abs(v.sum()) > roundoff * gross) prediction.uncertainty = v.uncertainty / std::abs(v.sum());
  prediction.stroke = stroke_of(best.arm);
  prediction.stroke_uncertainty = StrokeUncertainty{.arm_amplitudes = best.amplitude_uncertainty,
                                                    .sin_phase_shift = best.sin_uncertainty};
  prediction.sin_phase_shift = prediction.stroke.sin_phase_shift();
  prediction.arm_means = {best.arm_means[0], best.arm_means[1]};
  prediction.validity = fmt::format(
      "exact unsteady Stokes flow of three spheres with beads' and fluid's inertia; finite amplitude from "
      "exact steady Stokes flow; {}; compressibility and the lattice's own errors are not in it",
      question.surroundings.box
          ? "images in the layout's box as unsteady Faxen pairs with their Reynolds stress"
          : "no box");
  prediction.settings.emplace_back(
      "mobility", question.surroundings.box ? "exact, box by unsteady Faxen pairs" : "exact, unsteady");
  prediction.settings.emplace_back("velocity_quasi_static", v.quasi_static);
  prediction.settings.emplace_back("velocity_by_stroke", v.by_stroke);
  prediction.settings.emplace_back("velocity_by_drift", v.by_drift);
  prediction.settings.emplace_back("velocity_by_reynolds_stress", v.by_reynolds_stress);
  prediction.settings.emplace_back("velocity_by_box", v.by_box);
  prediction.settings.emplace_back("velocity_by_amplitude", v.by_amplitude);
  add_settings(question, prediction);
  mark_unusable_if_beads_touch(question, prediction);
  return prediction;
}

}  // namespace beadswim
