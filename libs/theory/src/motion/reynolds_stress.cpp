#include "beadswim/theory/reynolds_stress.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "beadswim/core/gauss_legendre.hpp"
#include "lone_sphere_flow.hpp"

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

/// Integrates r^2 times the integrand along a ray from the centre of a bead, r: distance from the centre
/// [length]. `cosine`: cosine of the angle between the ray and x. `farthest`: distance at which the ray ends
/// [length]. Outside the bead, the integration variable is q with r = a/q^2, which also resolves large
/// penetration depths.
ReynoldsForm radial_integral(const ReynoldsStress& stress, int bead, double radius, double cosine,
                             double farthest, const std::vector<QuadratureNode>& nodes) {
  const double sine = std::sqrt(1 - cosine * cosine), center = stress.center()[bead];
  const double q_end = std::sqrt(radius / farthest);  // 0 for an infinite ray
  Eigen::Matrix3cd within = Eigen::Matrix3cd::Zero(), beyond = Eigen::Matrix3cd::Zero();
  for (const auto& [place, weight] : nodes) {
    const double r_in = radius * place;
    within += weight * radius * r_in * r_in * stress.integrand(center + r_in * cosine, r_in * sine);
    const double q = q_end + (1 - q_end) * place, r = radius / (q * q);
    beyond += weight * (1 - q_end) * 2 * r * r * r / q * stress.integrand(center + r * cosine, r * sine);
  }
  return {.total = within + beyond, .inside = within};
}

/// Integrates over all space with `count` nodes per coordinate. Planes in the middle of the gaps divide space
/// into one region per bead, in which the integrand is smooth in polar coordinates about the bead.
ReynoldsForm space_integral(const ReynoldsStress& stress, const CollinearSwimmer& swimmer, int count) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::vector<QuadratureNode> nodes = gauss_legendre(count, 0, 1);
  const std::array<double, 2> gaps = gaps_at_rest(swimmer);
  ReynoldsForm sum{.total = Eigen::Matrix3cd::Zero(), .inside = Eigen::Matrix3cd::Zero()};
  for (int bead = 0; bead < 3; ++bead) {
    const double radius = swimmer.radius[bead];
    for (const int side : {-1, 1}) {
      const int arm = side < 0 ? bead - 1 : bead;
      const double plane = arm < 0 || arm > 1 ? infinite : radius + gaps[arm] / 2;
      for (const auto& [cosine, weight] : nodes) {
        const double ring = 2 * std::numbers::pi * weight;
        const ReynoldsForm ray = radial_integral(stress, bead, radius, side * cosine, plane / cosine, nodes);
        sum.total += ring * ray.total;
        sum.inside += ring * ray.inside;
      }
    }
  }
  return sum;
}

}  // namespace

ReynoldsForm reynolds_stress_form(const CollinearSwimmer& swimmer, double fluid_density,
                                  const Eigen::Vector3d& towing) {
  // Relative difference of the results of two successive quadrature rules at which the refinement ends. The
  // error of the finer rule is at most a third of this difference.
  constexpr double converged = 3e-5;
  constexpr int min_count = 16, max_count = 128;
  const ReynoldsStress stress(swimmer, fluid_density, towing);
  ReynoldsForm before = space_integral(stress, swimmer, min_count), now = before;
  for (int count = 3 * min_count / 2; count <= max_count; count = 3 * count / 2) {
    now = space_integral(stress, swimmer, count);
    const double change = (now.total - before.total).cwiseAbs().maxCoeff();
    if (change <= converged * now.total.cwiseAbs().maxCoeff()) break;
    before = now;
  }
  return {.total = fluid_density * now.total, .inside = fluid_density * now.inside};
}

double reynolds_stress_velocity(const Eigen::Matrix3cd& form, const Eigen::Vector3cd& induced_force) {
  return (induced_force.transpose() * form * induced_force.conjugate()).value().real() / 2;
}

}  // namespace beadswim
