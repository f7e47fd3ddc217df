#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace beadswim {

/// Returns the drag of two equal spheres that move with the velocity U along their line of centres, divided
/// by 6 pi eta a U: the series of Stimson and Jeffery, Proc. R. Soc. A 111, 110 (1926). s: distance of the
/// centres divided by the radius a.
inline double stimson_jeffery(double s) {
  const double alpha = std::acosh(s / 2), sinh = std::sinh(alpha);
  double sum = 0;
  for (int n = 1; n * alpha < 22; ++n) {  // terms fall as exp(-2 n alpha)
    const double k = 2 * n + 1;
    const double fraction = (4 * std::pow(std::sinh(k * alpha / 2), 2) - k * k * sinh * sinh) /
                            (2 * std::sinh(k * alpha) + k * std::sinh(2 * alpha));
    sum += n * (n + 1) / ((2. * n - 1) * (2 * n + 3)) * (1 - fraction);
  }
  return 4 * sinh * sum / 3;
}

/// Returns the drag of two equal spheres that approach each other with the velocities U and -U, divided by 6
/// pi eta a U: the series of Brenner, Chem. Eng. Sci. 16, 242 (1961), for a sphere and a plane free surface.
inline double approaching_spheres(double s) {
  const double alpha = std::acosh(s / 2), sinh = std::sinh(alpha);
  double sum = 0;
  for (int n = 1; n * alpha < 22; ++n) {
    const double k = 2 * n + 1;
    const double fraction = (4 * std::pow(std::cosh(k * alpha / 2), 2) + k * k * sinh * sinh) /
                            (2 * std::sinh(k * alpha) - k * std::sinh(2 * alpha));
    sum += n * (n + 1) / ((2. * n - 1) * (2 * n + 3)) * (fraction - 1);
  }
  return 4 * sinh * sum / 3;
}

/// Two spheres of radii a_1 and a_2 in bispherical coordinates. The surfaces are xi = alpha and xi = -beta.
struct Bispherical {
  double alpha, beta, c;

  Bispherical(double a_1, double a_2, double distance)
      : alpha(std::acosh((distance * distance + a_1 * a_1 - a_2 * a_2) / (2 * distance * a_1))),
        beta(std::acosh((distance * distance + a_2 * a_2 - a_1 * a_1) / (2 * distance * a_2))),
        c(a_1 * std::sinh(alpha)) {}
};

/// Returns h_n and its derivative by |xi|, for rigid motion: (cosh xi - mu)^(3/2) rho^2 / c^2 = sum_n
/// h_n(|xi|) (P_n-1 - P_n+1).
inline Eigen::Vector2d rigid_motion(int n, double xi) {
  const double factor = std::numbers::sqrt2 * n * (n + 1) / (2 * n + 1);
  const double below = std::exp(-(n - 0.5) * xi), above = std::exp(-(n + 1.5) * xi);
  return {factor * (below / (2 * n - 1) - above / (2 * n + 3)), factor * (above - below) / 2};
}

/// Returns the resistance matrix of two spheres of any radii in Stokes flow [mass/time], by the stream
/// function (cosh xi - mu)^(-3/2) sum_n U_n(xi) (P_n-1 - P_n+1) of Stimson and Jeffery. U_n consists of
/// exp(+-(n-1/2) xi) and exp(+-(n+3/2) xi). The no-slip condition: on both surfaces, U_n and dU_n/dxi are
/// those of rigid motion.
inline Eigen::Matrix2d bispherical_resistance(double a_1, double a_2, double distance, double viscosity) {
  const Bispherical geometry(a_1, a_2, distance);
  const double alpha = geometry.alpha, beta = geometry.beta;
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (int n = 1; n * std::min(alpha, beta) < 22; ++n) {
    const double k[] = {n - 0.5, n + 1.5};
    Eigen::Matrix4d basis;         // rows U(alpha), U'(alpha), U(-beta), U'(-beta)
    for (int i = 0; i < 2; ++i) {  // columns exp(k (xi - alpha)), then exp(-k (xi + beta))
      const double across = std::exp(-k[i] * (alpha + beta));
      basis.col(i) << 1, k[i], across, k[i] * across;
      basis.col(2 + i) << across, -k[i] * across, 1, -k[i];
    }
    const Eigen::Vector2d on_1 = rigid_motion(n, alpha), on_2 = rigid_motion(n, beta);
    Eigen::Matrix<double, 4, 2> motion = Eigen::Matrix<double, 4, 2>::Zero();
    motion.col(0).head<2>() = on_1;
    motion.col(1).tail<2>() << on_2[0], -on_2[1];
    const Eigen::Matrix<double, 4, 2> part = basis.partialPivLu().solve(motion);
    for (int i = 0; i < 2; ++i) {
      sum.row(0) += (2 * n + 1) * std::exp(-k[i] * alpha) * part.row(i);
      sum.row(1) += (2 * n + 1) * std::exp(-k[i] * beta) * part.row(2 + i);
    }
  }
  return 2 * std::numbers::sqrt2 * std::numbers::pi * viscosity * geometry.c * sum;
}

}  // namespace beadswim
