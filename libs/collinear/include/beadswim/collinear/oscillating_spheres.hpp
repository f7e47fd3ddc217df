#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

// clang-format off
// Flow around N rigid spheres on a line that oscillate along this line, by multipole expansion. The fluid is
// unbounded and at rest at infinity. All quantities vary as Re(q exp(i omega t)):
//
//   eta alpha^2 u = -grad p + eta laplacian u,   div u = 0,   alpha = sqrt(i omega rho/eta),   Re alpha > 0
//   u = U_j x^ on the surface of sphere j at its mean position
//
// With alpha = 0 this is steady Stokes flow. The flow is the sum of two series of axisymmetric multipoles around each
// sphere, n = 1 .. L. In polar coordinates (r, theta) around its centre, theta from the line, with the radius a of the
// sphere, q = a/r, x = alpha r and the Legendre polynomials P_n(cos theta):
//
//   potential   a^(n+2) grad(P_n r^-(n+1))        u_r = -(n+1) q^(n+2) P_n,        u_theta = q^(n+2) dP_n/dtheta
//   viscous     a^n curl curl(r P_n r^-(n-1) h_n) u_r = n(n+1) q^n h_n P_n,        u_theta = q^n (2 g_(n-1) - n h_n) dP_n/dtheta
//
//   g_0 = e^-x,  g_1 = (1 + x) e^-x,  g_n = g_(n-1) + x^2 g_(n-2)/((2n-1)(2n-3)),     g_n' = -x g_(n-1)/(2n-1)
//   h_n = 2 (2n-1) (1 - g_n)/x^2 = [(2n-1) h_(n-1) - 2 g_(n-2)]/(2n-3),               x h_n' = 2 (g_(n-1) - h_n)
//
// For x -> 0 all g_n and h_n are 1, which gives the multipoles of steady Stokes flow. For |alpha a| >= 4, where the two
// series become nearly equal, the second series is rotational: h_n = -2 (2n-1) g_n/x^2, and g_n and h_n are multiplied by
// exp(alpha a). It has no pressure. The coefficients of the multipoles minimise the mean square of the error of u on the
// surfaces. The force of sphere j on the fluid follows from its coefficients c of n = 1, without the first term if the
// second series is rotational:
//
//   F_j = 8 pi eta a c_viscous - 4 pi eta alpha^2 a^3 c_potential - (4/3) pi eta alpha^2 a^3 U_j
// clang-format on
//
// Reference: Landau and Lifshitz, Fluid Mechanics, section 24 (one sphere). Page:
// docs/method/unsteady-multipole.md.

namespace beadswim {

/// Velocity of the flow and its gradient at a point, per unit velocity of each sphere. One column per sphere
/// that moves while the others are at rest. x is the coordinate along the line, s the distance from the line.
struct FlowAtPoint {
  Eigen::Matrix2Xcd velocity;  ///< rows u_x, u_s [1]
  /// Rows du_x/dx, du_s/dx, du_x/ds, du_s/ds [1/length].
  Eigen::Matrix<std::complex<double>, 4, Eigen::Dynamic> gradient;
};

/// Flow around N oscillating spheres on a line.
class OscillatingSpheres {
 public:
  /// Solves for the multipoles up to `order`. Radii and positions along the line are in [length]; spheres
  /// must not touch. `viscosity`: dynamic [mass/(length time)]. `alpha`: sqrt(i omega rho/eta) [1/length]; 0
  /// for steady flow.
  OscillatingSpheres(std::span<const double> radii, std::span<const double> positions, double viscosity,
                     std::complex<double> alpha, int order);

  int order() const { return order_; }
  int count() const { return static_cast<int>(radius_.size()); }
  double radius(int sphere) const { return radius_[sphere]; }
  double position(int sphere) const { return position_[sphere]; }
  std::complex<double> alpha() const { return alpha_; }

  /// Returns the N x N matrix of the forces of the spheres on the fluid per velocity of the spheres
  /// [mass/time]. It is symmetric within the truncation error.
  const Eigen::MatrixXcd& resistance() const { return resistance_; }

  /// Returns the velocity at the point (x, s) outside of the spheres, as FlowAtPoint::velocity.
  Eigen::Matrix2Xcd velocity(double x, double s) const;

  /// Returns the flow at the point (x, s) outside of the spheres.
  FlowAtPoint at(double x, double s) const;

  /// Returns the derivative of u_theta along the outward normal on the surface of a sphere, one column per
  /// moving sphere [1/length]. `cosine`: cos(theta).
  Eigen::RowVectorXcd surface_shear(int sphere, double cosine) const;

 private:
  /// Coefficients of degree n of the first and the second series.
  struct Coefficients {
    std::complex<double> first, second;
  };

  /// Returns the coefficients of a sphere while the sphere `moving` moves.
  Coefficients coefficients_of(int sphere, int n, int moving) const {
    const int row = 2 * order_ * sphere + n - 1;
    return {.first = coefficients_(row, moving), .second = coefficients_(row + order_, moving)};
  }

  std::vector<double> radius_, position_;
  std::complex<double> alpha_;
  int order_;
  /// Rows: for each sphere the L potential, then the L viscous multipoles. Columns: moving sphere.
  Eigen::MatrixXcd coefficients_;
  Eigen::MatrixXcd resistance_;
};

}  // namespace beadswim
