#include "beadswim/theory/reynolds_stress.hpp"

#include <cmath>
#include <numbers>

#include "beadswim/core/gauss_legendre.hpp"
#include "lone_sphere_flow.hpp"
#include "outside_nodes.hpp"

namespace beadswim {

namespace {

/// Integrand of the matrix Q (reynolds_stress.hpp) on the half-plane (x, s), from the flows of the three
/// spheres. x: coordinate along the axis of the swimmer; s: distance from this axis [length].
class ReynoldsStress {
 public:
  ReynoldsStress(const CollinearSwimmer& swimmer, double fluid_density, const Eigen::Vector3d& towing)
      : swimmer_(swimmer),
        center_(rest_positions(swimmer)),
        alpha_(inverse_penetration_depth(swimmer, fluid_density)),
        towing_(towing) {}

  const LinePositions& center() const { return center_; }

  /// Returns the matrix of the elements u_i u_j* : grad u^ at (x, s). u_i is the oscillating flow of sphere i
  /// per induced force, u^ the steady flow of the towed spheres.
  Eigen::Matrix3cd integrand(double x, double s) const {
    Eigen::Matrix<std::complex<double>, 3, 2> flow;  // row: sphere; column: component along x, along s
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
    for (int i = 0; i < 3; ++i) {
      const double dx = x - center_[i];
      flow.row(i) = oscillating_sphere_flow(swimmer_.radius[i], swimmer_.viscosity, alpha_, dx, s);
      gradient += towing_[i] * towed_sphere_gradient(swimmer_.radius[i], swimmer_.viscosity, dx, s);
    }
    const Eigen::Matrix2d strain = (gradient + gradient.transpose()) / 2;
    return flow * strain * flow.adjoint();
  }

 private:
  const CollinearSwimmer& swimmer_;
  LinePositions center_;
  std::complex<double> alpha_;
  Eigen::Vector3d towing_;
};

/// Returns the integral over the volume of the beads.
Eigen::Matrix3cd integral_within(const ReynoldsStress& stress, const CollinearSwimmer& swimmer) {
  constexpr int count = 28;
  Eigen::Matrix3cd sum = Eigen::Matrix3cd::Zero();
  for (int bead = 0; bead < 3; ++bead) {
    for (const auto& [r, thickness] : gauss_legendre(count, 0, swimmer.radius[bead])) {
      for (const auto& [cosine, weight] : gauss_legendre(count, -1, 1))
        sum += 2 * std::numbers::pi * r * r * thickness * weight *
               stress.integrand(stress.center()[bead] + r * cosine, r * std::sqrt(1 - cosine * cosine));
    }
  }
  return sum;
}

}  // namespace

ReynoldsForm reynolds_stress_form(const CollinearSwimmer& swimmer, double fluid_density,
                                  const Eigen::Vector3d& towing) {
  constexpr int nodes_per_panel = 6;
  const ReynoldsStress stress(swimmer, fluid_density, towing);
  const double depth = std::sqrt(2.0) / std::abs(inverse_penetration_depth(swimmer, fluid_density));
  const Eigen::Matrix3cd within = integral_within(stress, swimmer);
  Eigen::Matrix3cd total = within;
  for (const auto& [x, s, weight] : outside_nodes(swimmer.radius, stress.center(), depth, nodes_per_panel))
    total += weight * stress.integrand(x, s);
  return {.total = fluid_density * total, .inside = fluid_density * within};
}

double reynolds_stress_velocity(const Eigen::Matrix3cd& form, const Eigen::Vector3cd& induced_force) {
  return (induced_force.transpose() * form * induced_force.conjugate()).value().real() / 2;
}

}  // namespace beadswim
