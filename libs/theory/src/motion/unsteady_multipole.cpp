#include "beadswim/theory/unsteady_multipole.hpp"

#include <Eigen/LU>

#include "beadswim/collinear/multipole_mobility.hpp"
#include "beadswim/core/complex.hpp"
#include "beadswim/core/error.hpp"

namespace beadswim {

std::optional<MultipoleResolution> sufficient_resolution(const CollinearSwimmer& swimmer) {
  constexpr double tolerance = 1e-10;  // of the steady mobility
  constexpr int min_order = 10, max_order = 100, nodes = 8;
  try {
    const int order =
        multipole_mobility(swimmer.radius, rest_positions(swimmer), swimmer.viscosity, tolerance).order;
    if (order > max_order) return std::nullopt;
    return MultipoleResolution{.order = std::max(order, min_order), .nodes = nodes};
  } catch (const InputError&) {  // the beads touch or nearly touch
    return std::nullopt;
  }
}

MultipoleResolution coarser(const MultipoleResolution& resolution) {
  return {.order = 3 * resolution.order / 4, .nodes = 3 * resolution.nodes / 4};
}

UnsteadyMultipoles unsteady_multipoles(const CollinearSwimmer& swimmer, double fluid_density,
                                       const MultipoleResolution& resolution) {
  const auto& [order, nodes] = resolution;
  const LinePositions positions = rest_positions(swimmer);
  const double omega = swimmer.angular_frequency(), eta = swimmer.viscosity;
  const OscillatingSpheres unsteady(swimmer.radius, positions, eta,
                                    inverse_penetration_depth(swimmer, fluid_density), order);
  const OscillatingSpheres steady(swimmer.radius, positions, eta, 0, order);
  const Complex i_omega(0, omega);
  Eigen::Matrix3cd with_beads = unsteady.resistance(), with_fluid = unsteady.resistance();
  for (int i = 0; i < 3; ++i) {
    with_beads(i, i) += i_omega * sphere_mass(swimmer.radius[i], swimmer.density[i]);
    with_fluid(i, i) += i_omega * sphere_mass(swimmer.radius[i], fluid_density);
  }
  return {.mobility = with_beads.inverse(),
          .induced_mobility = with_fluid.inverse(),
          .mean_forces = mean_forces(unsteady, steady, eta, omega, nodes)};
}

MeanMotion mean_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer,
                       const Eigen::Vector3cd& displacement, const Eigen::Vector3cd& flow_velocity) {
  const MeanForces& forces = flow.mean_forces;
  const Eigen::VectorXcd velocity = Complex(0, swimmer.angular_frequency()) * displacement;
  Eigen::Vector3d drift, reynolds;
  for (int k = 0; k < 3; ++k) {
    drift[k] = mean_of(forces.drift[k], flow_velocity, velocity);
    reynolds[k] = mean_of(forces.reynolds[k], flow_velocity, flow_velocity);
  }
  const double towing = forces.resistance.sum();
  MeanMotion motion;
  motion.by_drift = drift.sum() / towing;
  motion.by_reynolds_stress = reynolds.sum() / towing;
  motion.bead_velocities = forces.resistance.partialPivLu().solve(drift + reynolds);
  const Eigen::Vector3d force = drift + reynolds - forces.resistance.rowwise().sum() * motion.velocity();
  motion.arm_changes = {-force[0] / swimmer.stiffness[0], force[2] / swimmer.stiffness[1]};
  return motion;
}

MeanMotion mean_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer,
                       const LinearResponse& response) {
  return mean_motion(flow, swimmer, response.displacement,
                     Complex(0, swimmer.angular_frequency()) * response.displacement);
}

ExactMotion exact_motion(const UnsteadyMultipoles& flow, const CollinearSwimmer& swimmer) {
  const LinearResponse response = linear_response(swimmer, flow.mobility);
  return {.response = response, .mean = mean_motion(flow, swimmer, response)};
}

}  // namespace beadswim
