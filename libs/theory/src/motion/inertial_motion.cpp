#include "beadswim/theory/inertial_motion.hpp"

#include <Eigen/LU>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/collinear/unsteady_sphere.hpp"
#include "beadswim/core/complex.hpp"
#include "beadswim/theory/box_mobility.hpp"

namespace beadswim {

namespace {

/// Returns the mass of each bead minus the mass of the fluid that it displaces [mass].
Eigen::Vector3d excess_masses(const InertialScene& scene) {
  Eigen::Vector3d excess;
  for (int i = 0; i < 3; ++i) {
    excess[i] = sphere_mass(scene.swimmer.radius[i], scene.swimmer.density[i] - scene.fluid_density);
  }
  return excess;
}

/// Returns the mean of r^2 over the induced force of a bead, where r is the distance from the centre
/// [length^2]. This mean replaces a^2 in the steady flow of a bead of radius a. The parts of the force on the
/// surface, where r^2 = a^2, and in the volume, where the mean of r^2 is 3/5 a^2, have the weights
/// (1 + kappa)/D and (kappa^2/3)/D, with kappa = alpha a and D = 1 + kappa + kappa^2/3.
Complex steady_size(double radius, Complex kappa) {
  return radius * radius * (1.0 + kappa + kappa * kappa / 5.0) / induced_force_factor(kappa);
}

}  // namespace

InertialScene unbounded_scene(const Question& question) {
  return {.swimmer = question.line(),
          .fluid_density = question.fluid_density(),
          .flow = LineFlow(question.line().viscosity),
          .positions = rest_positions(question.line())};
}

InertialScene inertial_scene(const Question& question) {
  InertialScene scene = unbounded_scene(question);
  if (!question.surroundings.box) return scene;
  scene.flow = box_line_flow(*question.surroundings.box, question.line().viscosity);
  scene.positions = rest_positions(question.line(), *question.surroundings.box);
  return scene;
}

Eigen::Matrix3cd induced_mobility(const InertialScene& scene) {
  const CollinearSwimmer& swimmer = scene.swimmer;
  const Complex alpha = inverse_penetration_depth(swimmer, scene.fluid_density);
  Eigen::Matrix3cd mobility;
  for (int i = 0; i < 3; ++i) {
    const SizeFactor size_i = sphere_factor(alpha * swimmer.radius[i]);
    mobility(i, i) = self_mobility(swimmer.radius[i], swimmer.viscosity) /
                         induced_force_factor(alpha * swimmer.radius[i]) +
                     total_flow(scene.flow.unsteady_images(alpha, scene.positions[i]), size_i * size_i).value;
    for (int j = i + 1; j < 3; ++j) {
      const SizeFactor sizes = size_i * sphere_factor(alpha * swimmer.radius[j]);
      const UnsteadyFlow flow = scene.flow.unsteady(alpha, scene.positions[i], scene.positions[j]);
      mobility(i, j) = mobility(j, i) = total_flow(flow, sizes).value;
    }
  }
  return mobility;
}

Eigen::Matrix3cd unsteady_mobility(const InertialScene& scene) {
  const Eigen::Matrix3cd induced = induced_mobility(scene);
  const Complex i_omega = i_unit * scene.swimmer.angular_frequency();
  const Eigen::Matrix3cd with_mass =
      Eigen::Matrix3cd::Identity() + i_omega * induced * excess_masses(scene).cast<Complex>().asDiagonal();
  return with_mass.partialPivLu().solve(induced);
}

Eigen::Vector3cd induced_forces(const InertialScene& scene, const LinearResponse& response) {
  const double omega = scene.swimmer.angular_frequency();
  // Adds -i omega (m - m_f) U to the other forces, where U = i omega xi is the velocity of a bead, m its mass
  // and m_f the mass of the fluid that it displaces.
  return response.force +
         omega * omega * excess_masses(scene).cast<Complex>().cwiseProduct(response.displacement);
}

DriftForm drift_form(const InertialScene& scene) {
  const CollinearSwimmer& swimmer = scene.swimmer;
  const Complex alpha = inverse_penetration_depth(swimmer, scene.fluid_density);
  DriftForm form;
  form.towing = towing_forces(rotne_prager_mobility(scene.flow, swimmer, scene.positions).value);
  for (int j = 0; j < 3; ++j) {
    const double x_j = scene.positions[j], a_j = swimmer.radius[j];
    for (int i = 0; i < 3; ++i) {
      const double x_i = scene.positions[i];
      const Complex kappa_i = alpha * swimmer.radius[i];
      const UnsteadyFlow unsteady =
          i == j ? scene.flow.unsteady_images(alpha, x_j) : scene.flow.unsteady(alpha, x_j, x_i);
      const SteadyFlow steady = i == j ? scene.flow.steady_images(x_j) : scene.flow.steady(x_j, x_i);
      // clang-format off
      form.by_receiver(j, i) = total_flow(unsteady, surface_mean_factor(alpha * a_j) * sphere_factor(kappa_i)).by_receiver;
      form.by_source(j, i)   = steady.oseen.by_source
                             + (a_j * a_j + steady_size(swimmer.radius[i], kappa_i)) * steady.laplacian.by_source;
      // clang-format on
    }
  }
  return form;
}

Eigen::Vector3d drift_velocities(const DriftForm& form, const Eigen::Vector3cd& displacement,
                                 const Eigen::Vector3cd& force) {
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      const Complex by_place = std::conj(displacement[j]) * form.by_receiver(j, i) * force[i];
      const Complex by_source = std::conj(displacement[i]) * form.by_source(j, i) * force[i];
      drift[j] += (by_place + by_source).real() / 2;
    }
  }
  return drift;
}

double lagrangian_drift(const InertialScene& scene, const LinearResponse& response) {
  const DriftForm form = drift_form(scene);
  return form.towing.dot(drift_velocities(form, response.displacement, induced_forces(scene, response)));
}

ReynoldsForm reynolds_form(const InertialScene& scene) {
  const Eigen::Vector3d towing = towing_forces(rest_mobility(scene.swimmer, rotne_prager).value);
  return reynolds_stress_form(scene.swimmer, scene.fluid_density, towing);
}

}  // namespace beadswim
