#include "beadswim/plan/lattice_lag.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "beadswim/core/complex.hpp"
#include "beadswim/theory/reynolds_stress.hpp"

namespace beadswim {
namespace {

constexpr double frequency_step = 0.02;  // relative change of frequency in the difference quotient

}  // namespace

// The matrix M is a function of omega rho/eta, divided by eta (omega: frequency, rho: density, eta:
// viscosity). Replacing eta by eta (1 - eps) therefore divides M by 1 - eps and omega by 1 - eps. The
// derivative dM/d(ln omega) is a central difference.
Eigen::Matrix3cd LatticeLag::FrequencySamples::with_delayed_stress(Complex eps) const {
  return (at + eps * (above - below) / (2 * frequency_step)) / (1.0 - eps);
}

template <class Flow>
LatticeLag::FrequencySamples LatticeLag::frequency_samples(const Flow& flow) const {
  const auto at = [&](double factor) {
    InertialScene other = scene_;
    other.swimmer.period = scene_.swimmer.period / factor;
    return flow(other);
  };
  return {.at = flow(scene_), .below = at(1 - frequency_step), .above = at(1 + frequency_step)};
}

LatticeLag::LatticeLag(const Question& question)
    : scene_(inertial_scene(question)),
      box_(question.surroundings.box),
      induced_(frequency_samples(induced_mobility)),
      slopes_(frequency_samples([](const InertialScene& scene) { return drift_form(scene).by_receiver; })),
      form_(drift_form(scene_)),
      reynolds_(reynolds_form(scene_).total),
      exact_(motion(unsteady_mobility(scene_), induced_.at, form_)) {}

/// Returns the motion of the driven swimmer. `mobility`: velocities of the beads per force on the beads
/// [time/mass]. `induced`: velocities of the beads per induced force on the fluid [time/mass].
LatticeLag::Motion LatticeLag::motion(const Eigen::Matrix3cd& mobility, const Eigen::Matrix3cd& induced,
                                      const DriftForm& form) const {
  const LinearResponse response = linear_response(scene_.swimmer, mobility);
  const Eigen::Vector3cd velocity = i_unit * scene_.swimmer.angular_frequency() * response.displacement;
  const Eigen::Vector3cd force = induced.partialPivLu().solve(velocity);
  return {.arm = response.arm,
          .drift = form.towing.dot(drift_velocities(form, response.displacement, force)),
          .reynolds = reynolds_stress_velocity(reynolds_, force)};
}

// Returns the mobility U/F, where the force of the fluid acts on beads one time step late: the last equation
// in lattice_lag.hpp. U are the velocities of the beads, F the forces of driving, springs and dashpots.
Eigen::Matrix3cd LatticeLag::with_delayed_links(const Eigen::Matrix3cd& induced,
                                                const LatticeTiming& timing) const {
  const CollinearSwimmer& swimmer = scene_.swimmer;
  const Complex i_omega = i_unit * swimmer.angular_frequency();
  const double nu = swimmer.viscosity / scene_.fluid_density;
  const double delay = 1.5 * nu / (timing.sound_speed * timing.sound_speed) + timing.step;
  Eigen::Matrix3cd impedance = induced.inverse();
  for (int b = 0; b < 3; ++b)
    impedance(b, b) -= i_omega * sphere_mass(swimmer.radius[b], scene_.fluid_density);
  impedance *= std::exp(-i_omega * timing.step);
  for (int b = 0; b < 3; ++b) {
    const double friction = 6 * std::numbers::pi * swimmer.viscosity * swimmer.radius[b];
    impedance(b, b) += i_omega * (sphere_mass(swimmer.radius[b], swimmer.density[b]) +
                                  (timing.corrects_delay ? friction * delay : 0));
  }
  return impedance.inverse();
}

MotionValues LatticeLag::errors(const LatticeTiming& timing) const {
  const double nu = scene_.swimmer.viscosity / scene_.fluid_density;
  const Complex eps =
      i_unit * scene_.swimmer.angular_frequency() * nu / (timing.sound_speed * timing.sound_speed);
  const SoundFlow sound = sound_flow(scene_, box_, timing.sound_speed);
  DriftForm form = form_;
  form.by_receiver = slopes_.with_delayed_stress(eps) + sound.by_receiver;
  const Eigen::Matrix3cd late = induced_.with_delayed_stress(eps) + sound.value;
  const Motion lattice = motion(with_delayed_links(late, timing), late, form);

  MotionValues errors = MotionValues::Zero();
  for (int arm = 0; arm < 2; ++arm) {
    const double size = std::abs(exact_.arm[arm]);
    if (size > 0) errors[1 + arm] = std::abs(lattice.arm[arm]) / size - 1;
  }
  const double velocity = std::abs(exact_.drift + exact_.reynolds);
  if (velocity > 0)
    errors[0] =
        (std::abs(lattice.drift - exact_.drift) + std::abs(lattice.reynolds - exact_.reynolds)) / velocity;
  return errors;
}

}  // namespace beadswim
