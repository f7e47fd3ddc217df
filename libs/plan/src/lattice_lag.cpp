#include "beadswim/plan/lattice_lag.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "beadswim/plan/sound_flow.hpp"
#include "beadswim/theory/inertial_motion.hpp"
#include "beadswim/theory/reynolds_stress.hpp"

namespace beadswim {
namespace {

using Complex = std::complex<double>;
constexpr Complex i_unit{0, 1};

/// What a flow that is a function of omega rho/eta, over eta, becomes with eta (1 - eps): from its values
/// with frequencies a little lower and higher.
struct Neighbours {
  static constexpr double apart = 0.02;

  Eigen::Matrix3cd at, below, above;

  Eigen::Matrix3cd with_late_stress(Complex eps) const {
    return (at + eps * (above - below) / (2 * apart)) / (1.0 - eps);
  }
};

template <class Flow>
Neighbours neighbours(const InertialScene& scene, const Flow& flow) {
  const auto at = [&](double factor) {
    InertialScene other = scene;
    other.swimmer.period = scene.swimmer.period / factor;
    return flow(other);
  };
  return {.at = flow(scene), .below = at(1 - Neighbours::apart), .above = at(1 + Neighbours::apart)};
}

/// Mass of fluid that a bead displaces, or of the bead itself [mass].
double sphere_mass(double radius, double density) {
  return 4 * std::numbers::pi / 3 * std::pow(radius, 3) * density;
}

/// U = M F on the lattice, `induced` being what the fluid does without delay of links.
Eigen::Matrix3cd with_late_links(const InertialScene& scene, const Eigen::Matrix3cd& induced,
                                 const LatticeTiming& timing) {
  const CollinearSwimmer& swimmer = scene.swimmer;
  const Complex i_omega = i_unit * swimmer.angular_frequency();
  const double nu = swimmer.viscosity / scene.fluid_density;
  const double delay = 1.5 * nu / (timing.sound_speed * timing.sound_speed) + timing.step;
  Eigen::Matrix3cd impedance = induced.inverse();
  for (int b = 0; b < 3; ++b)
    impedance(b, b) -= i_omega * sphere_mass(swimmer.radius[b], scene.fluid_density);
  impedance *= std::exp(-i_omega * timing.step);
  for (int b = 0; b < 3; ++b) {
    const double friction = 6 * std::numbers::pi * swimmer.viscosity * swimmer.radius[b];
    impedance(b, b) += i_omega * (sphere_mass(swimmer.radius[b], swimmer.density[b]) +
                                  (timing.corrects_delay ? friction * delay : 0));
  }
  return impedance.inverse();
}

/// Stroke and velocity.
struct Motion {
  Eigen::Vector2cd arm;
  double drift = 0, reynolds = 0;
};

/// mobility: of forces on beads; induced: of what beads push the fluid with.
Motion motion(const InertialScene& scene, const Eigen::Matrix3cd& mobility, const Eigen::Matrix3cd& induced,
              const DriftForm& form) {
  const LinearResponse response = linear_response(scene.swimmer, mobility);
  const Eigen::Vector3cd velocity = i_unit * scene.swimmer.angular_frequency() * response.displacement;
  const Eigen::Vector3cd force = induced.partialPivLu().solve(velocity);
  return {.arm = response.arm,
          .drift = lagrangian_drift(form, response.displacement, force),
          .reynolds = reynolds_stress_velocity(reynolds_form(scene).whole, force)};
}

}  // namespace

LagErrors lag_errors(const Question& question, const LatticeTiming& timing) {
  const InertialScene scene = inertial_scene(question);
  const double nu = scene.swimmer.viscosity / scene.fluid_density;
  const Complex eps =
      i_unit * scene.swimmer.angular_frequency() * nu / (timing.sound_speed * timing.sound_speed);
  const Neighbours induced = neighbours(scene, induced_mobility);
  const Neighbours slopes =
      neighbours(scene, [](const InertialScene& s) { return drift_form(s).by_receiver; });
  const SoundFlow sound = sound_flow(scene, question.box, timing.sound_speed);

  DriftForm form = drift_form(scene);
  const Motion exact = motion(scene, unsteady_mobility(scene), induced.at, form);
  form.by_receiver = slopes.with_late_stress(eps) + sound.by_receiver;
  const Eigen::Matrix3cd late = induced.with_late_stress(eps) + sound.value;
  const Motion lattice = motion(scene, with_late_links(scene, late, timing), late, form);

  LagErrors errors;
  for (int arm = 0; arm < 2; ++arm) {
    const double size = std::abs(exact.arm[arm]);
    if (size > 0) errors.arm_amplitudes[arm] = std::abs(lattice.arm[arm]) / size - 1;
  }
  const double velocity = std::abs(exact.drift + exact.reynolds);
  if (velocity > 0)
    errors.velocity =
        (std::abs(lattice.drift - exact.drift) + std::abs(lattice.reynolds - exact.reynolds)) / velocity;
  return errors;
}

}  // namespace beadswim
