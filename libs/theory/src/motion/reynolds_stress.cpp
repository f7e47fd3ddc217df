#include "beadswim/theory/reynolds_stress.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/collinear/oscillating_spheres.hpp"
#include "beadswim/collinear/pair_mobility.hpp"
#include "beadswim/collinear/unsteady_sphere.hpp"
#include "beadswim/core/complex.hpp"
#include "beadswim/core/gauss_legendre.hpp"
#include "outside_nodes.hpp"

namespace beadswim {

namespace {

/// Integrand of the matrix Q (reynolds_stress.hpp) on the half-plane (x, s), from the flows of the three
/// spheres, each alone. x: coordinate along the axis of the swimmer; s: distance from this axis [length].
class ReynoldsStress {
 public:
  ReynoldsStress(const CollinearSwimmer& swimmer, double fluid_density, const Eigen::Vector3d& towing)
      : center_(rest_positions(swimmer)) {
    const Complex alpha = inverse_penetration_depth(swimmer, fluid_density);
    for (int i = 0; i < 3; ++i) {
      const std::array radius{swimmer.radius[i]}, position{center_[i]};
      const double mobility = self_mobility(radius[0], swimmer.viscosity);
      spheres_.push_back({.oscillating = {radius, position, swimmer.viscosity, alpha, 1},
                          .towed = {radius, position, swimmer.viscosity, 0, 1},
                          .speed = mobility / induced_force_factor(alpha * radius[0]),
                          .towed_speed = towing[i] * mobility});
    }
  }

  const LinePositions& center() const { return center_; }

  /// Returns the matrix of the elements u_i u_j* : grad u^ at (x, s). u_i is the oscillating flow of sphere i
  /// per induced force, u^ the steady flow of the towed spheres. Inside a sphere its own flow is uniform.
  Eigen::Matrix3cd integrand(double x, double s) const {
    Eigen::Matrix<Complex, 3, 2> flow;  // row: sphere; column: component along x, along s
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
    for (int i = 0; i < 3; ++i) {
      const auto& [oscillating, towed, speed, towed_speed] = spheres_[i];
      flow.row(i) << speed, 0.0;
      if (std::hypot(x - center_[i], s) <= oscillating.radius(0)) continue;
      flow.row(i) = speed * oscillating.velocity(x, s).transpose();
      gradient += towed_speed * towed.at(x, s).gradient.real().reshaped(2, 2);
    }
    const Eigen::Matrix2d strain = (gradient + gradient.transpose()) / 2;
    return flow * strain * flow.adjoint();
  }

 private:
  /// Flows of one sphere per velocity, and its velocities per induced force and in the towed swimmer.
  struct LoneSphere {
    OscillatingSpheres oscillating, towed;
    Complex speed;
    double towed_speed;
  };

  LinePositions center_;
  std::vector<LoneSphere> spheres_;
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
