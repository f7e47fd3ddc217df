#include "confidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "beadswim/theory/truncation_error.hpp"

namespace beadswim {

namespace {

/// sqrt(2 nu / omega) [length]: how far vorticity spreads in a period.
double penetration_depth(const Question& question) {
  const double kinematic_viscosity = question.swimmer.viscosity / question.fluid_density;
  return std::sqrt(2 * kinematic_viscosity / question.swimmer.angular_frequency());
}

/// Velocities below this are roundoff [length/time].
double velocity_roundoff(const CollinearSwimmer& swimmer, const Stroke& stroke) {
  constexpr double relative_roundoff = 1e-12;
  const double largest_swing = std::max(stroke.amplitude[0], stroke.amplitude[1]);
  return relative_roundoff * swimmer.angular_frequency() * largest_swing * largest_swing / swimmer.arm[0];
}

}  // namespace

std::optional<double> estimated_exact_velocity(const CollinearSwimmer& swimmer,
                                               const SecondOrderMotion& rotne_prager) {
  const std::optional<double> excess = rotne_prager_over_exact(separation_ratio(swimmer));
  const bool moves = std::abs(rotne_prager.velocity) > velocity_roundoff(swimmer, rotne_prager.stroke);
  if (!excess || !moves) return std::nullopt;
  return rotne_prager.velocity / *excess;
}

std::optional<double> relative_uncertainty(double velocity, std::optional<double> exact,
                                           double amplitude_change) {
  if (!exact) return std::nullopt;
  return std::hypot(velocity / *exact - 1, amplitude_change);
}

bool beads_stay_apart(const CollinearSwimmer& swimmer, const Stroke& stroke) {
  const auto apart = [&](int arm) {
    return swimmer.arm[arm] - stroke.amplitude[arm] > swimmer.radius[arm] + swimmer.radius[arm + 1];
  };
  return apart(0) && apart(1);
}

void add_common_limits(const Question& question, Prediction& prediction) {
  const CollinearSwimmer& swimmer = question.swimmer;
  const double mean_arm = (swimmer.arm[0] + swimmer.arm[1]) / 2;
  const double depth_over_arm = penetration_depth(question) / mean_arm;
  prediction.validity += fmt::format(
      "; second order in amplitude (what it leaves out changes the velocity by about {:.1f} %); alone in "
      "unbounded fluid; quasi-static, so no inertia of fluid or beads (penetration depth {:.2f} arms; for "
      "equal "
      "beads at l/lambda = 5 inertia changes the velocity by -26 % at 0.52, -3 % at 0.73, +7 % at 1.13, +5 % "
      "at "
      "1.63 arms)",
      100 * finite_amplitude_change(swimmer, prediction.stroke.amplitude), depth_over_arm);
  prediction.usable = beads_stay_apart(swimmer, prediction.stroke);
  if (!prediction.usable)
    prediction.validity += "; not usable: with this stroke the beads would run into each other";
  prediction.settings.emplace_back("fluid", "unbounded");
  prediction.settings.emplace_back("period", swimmer.period);
  prediction.settings.emplace_back("separation_ratio", separation_ratio(swimmer));
  prediction.settings.emplace_back("penetration_depth_over_arm", depth_over_arm);
}

}  // namespace beadswim
