#include "beadswim/theory/inertia_corrected.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "beadswim/mobility/rotne_prager.hpp"
#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/reynolds_stress.hpp"
#include "method_rows.hpp"

namespace beadswim {

namespace {

using Complex = std::complex<double>;

/// Stroke and velocity to second order in amplitude, in the box or in open space (inertia_corrected.hpp).
struct Motion {
  Eigen::Vector2cd arm;
  double drift = 0, reynolds = 0;  ///< velocities V_drift and V_R, times C_exact/C_RP [length/time]
  double within_beads = 0;         ///< part of `reynolds` from the volume of the beads [length/time]
};

/// Quantities in open space, which do not depend on the box.
struct OpenSpace {
  Eigen::Matrix2cd exact_impedance, pair_impedance;
  double geometry = 0, pair_geometry = 0;  ///< C in exact flow, C with Rotne-Prager mobility [1/length]
  ReynoldsForm reynolds;
};

OpenSpace open_space_of(const Question& question) {
  const CollinearMobility pairs = rest_mobility(question.swimmer, rotne_prager);
  return {.exact_impedance = arm_impedance(question.exact->mobility.value.cast<Complex>()),
          .pair_impedance = arm_impedance(pairs.value.cast<Complex>()),
          .geometry = geometry_factor(question.exact->mobility),
          .pair_geometry = geometry_factor(pairs),
          .reynolds = reynolds_form(unbounded_scene(question))};
}

Motion motion_in(const InertialScene& scene, const OpenSpace& space) {
  const Eigen::Matrix3cd unsteady = unsteady_mobility(scene);
  const Eigen::Matrix2cd impedance = space.exact_impedance + arm_impedance(unsteady) - space.pair_impedance;
  const Eigen::Vector2cd arm = driven_arms(scene.swimmer, impedance);
  const LinearResponse response = response_to_stroke(arm, unsteady, scene.swimmer.angular_frequency());
  const double exact_over_pairs = space.geometry / space.pair_geometry;
  const Eigen::Vector3cd force = induced_forces(scene, response);
  return {.arm = arm,
          .drift = exact_over_pairs * lagrangian_drift(scene, response),
          .reynolds = exact_over_pairs * reynolds_stress_velocity(space.reynolds.total, force),
          .within_beads = exact_over_pairs * reynolds_stress_velocity(space.reynolds.inside, force)};
}

double root_of_squares(std::initializer_list<double> parts) {
  double sum = 0;
  for (const double part : parts) sum += part * part;
  return std::sqrt(sum);
}

/// Returns the relative uncertainty of the velocity V_R by the Reynolds stress in a box, because V_R is
/// evaluated without images: sum of the arm lengths divided by the shortest edge of the box, at most 1.
/// Returns 0 in open space.
double unknown_share_of_reynolds(const Question& question) {
  if (!question.box) return 0;
  const double narrowest = question.box->box.lengths.minCoeff();
  return std::min(1.0, (question.swimmer.arm[0] + question.swimmer.arm[1]) / narrowest);
}

InertialVelocity velocity_parts(const Question& question, const OpenSpace& space, const Motion& open,
                                const Motion& boxed, double amplitude_change) {
  const SecondOrderMotion& second_order = question.exact->motion;
  const double kinematic =
      space.geometry * question.swimmer.angular_frequency() * stroke_of({open.arm[0], open.arm[1]}).area();
  InertialVelocity v;
  v.quasi_static = second_order.velocity;
  v.by_stroke = kinematic - v.quasi_static;
  v.by_drift = open.drift - kinematic;
  v.by_reynolds_stress = open.reynolds;
  v.by_box = boxed.drift + boxed.reynolds - open.drift - open.reynolds;
  const auto& [d1, d2] = second_order.stroke.amplitude;
  const double size = d1 * d2 > 0 ? std::abs(boxed.arm[0] * boxed.arm[1]) / (d1 * d2) : 1;
  v.by_amplitude = amplitude_change * size;

  // The relative error of each contribution due to the approximation by pairs of beads is estimated by the
  // relative error of the steady geometry factor. The errors have one cause, so their absolute values add.
  const double pair_error = std::abs(space.pair_geometry / space.geometry - 1);
  const double inertial = v.by_stroke + v.by_drift + v.by_reynolds_stress;
  const double amplitude_share = v.quasi_static != 0 ? std::abs(inertial / v.quasi_static) : 1;
  const double by_pairs = pair_error * (std::abs(v.by_stroke) + std::abs(v.by_drift) +
                                        std::abs(v.by_reynolds_stress) + std::abs(v.by_box));
  v.uncertainty = root_of_squares({by_pairs, boxed.within_beads,
                                   unknown_share_of_reynolds(question) * v.by_reynolds_stress,
                                   std::min(1.0, amplitude_share) * v.by_amplitude});
  return v;
}

Complex complex_of(const Stroke& stroke, int arm) {
  return std::polar(stroke.amplitude[arm], stroke.phase[arm]);
}

/// Returns an upper bound of the error of sin(delta_1 - delta_2) for the complex arm amplitudes y. x are the
/// arm amplitudes of the quasi-static stroke. The change from x to y has the relative error `relative_error`.
double sin_uncertainty(const Eigen::Vector2cd& x, const Eigen::Vector2cd& y, double relative_error) {
  if (x[0] == 0.0 || x[1] == 0.0 || y[1] == 0.0) return 0;
  const Complex shift = y[0] / y[1];
  const double angle = relative_error * std::abs(shift / (x[0] / x[1]) - 1.0);
  return std::abs(shift.real() / std::abs(shift)) * angle + angle * angle / 2;
}

}  // namespace

InertiaCorrected inertia_corrected(const Question& question) {
  const OpenSpace space = open_space_of(question);
  const Motion open = motion_in(unbounded_scene(question), space);
  const Motion boxed = question.box ? motion_in(inertial_scene(question), space) : open;
  const PeriodicMotion finite = exact_periodic_motion(question.swimmer);
  const SecondOrderMotion& small = question.exact->motion;

  InertiaCorrected best;
  best.velocity = velocity_parts(question, space, open, boxed, finite.velocity - small.velocity);
  best.arm_means = finite.arm_means;
  const double pair_error = std::abs(space.pair_geometry / space.geometry - 1);
  Eigen::Vector2cd quasi_static;
  for (int arm = 0; arm < 2; ++arm) {
    quasi_static[arm] = complex_of(small.stroke, arm);
    const Complex growth =
        small.stroke.amplitude[arm] > 0 ? complex_of(finite.stroke, arm) / quasi_static[arm] : 1;
    best.arm[arm] = boxed.arm[arm] * growth;
    const double change = std::abs(boxed.arm[arm] - quasi_static[arm]), size = std::abs(boxed.arm[arm]);
    const double relative_change = size > 0 ? change / size : 0;
    best.amplitude_uncertainty[arm] = relative_change * std::hypot(pair_error, std::abs(growth - 1.0));
  }
  best.sin_uncertainty = sin_uncertainty(quasi_static, boxed.arm, pair_error);
  return best;
}

}  // namespace beadswim
