#pragma once

#include <complex>

// Values of flow kernels on a line along x: the velocity along x at the receiver x_r, per unit force along x
// at the source x_s. Any coherent unit system.

namespace beadswim {

/// Value of a kernel K(x_r, x_s) and its two derivatives.
template <class T>
struct LineKernel {
  T value{};        ///< K(x_r, x_s)
  T by_receiver{};  ///< dK / dx_r
  T by_source{};    ///< dK / dx_s
};

/// Value and slope of a function of the displacement d = x_r - x_s. Kernels are composed of such functions.
template <class T>
struct LineValue {
  T value{};
  T slope{};

  LineValue& operator+=(const LineValue& other) {
    value += other.value;
    slope += other.slope;
    return *this;
  }
};

template <class Factor, class T>
auto operator*(const Factor& factor, const LineValue<T>& term) {
  return LineValue<decltype(factor * term.value)>{factor * term.value, factor * term.slope};
}

/// Kernel of steady Stokes flow. Two spheres of radii a_i and a_j that do not overlap have the mobility
/// oseen + (a_i^2 + a_j^2) laplacian.
struct SteadyFlow {
  LineKernel<double> oseen;      ///< G_xx [time/mass]
  LineKernel<double> laplacian;  ///< (1/6) laplacian of G_xx [time/(mass length^2)]
};

/// Kernel of unsteady Stokes flow at the angular frequency omega, with alpha^2 = i omega rho / eta. The radii
/// of the spheres multiply the two parts by different factors (unsteady_sphere.hpp). The parts nearly cancel
/// for small alpha, so their sum is evaluated separately.
struct UnsteadyFlow {
  LineKernel<std::complex<double>> helmholtz;  ///< decays as exp(-alpha r) [time/mass]
  LineKernel<std::complex<double>> harmonic;   ///< potential flow [time/mass]
  LineKernel<std::complex<double>> total;  ///< helmholtz + harmonic, without loss of significance [time/mass]
};

}  // namespace beadswim
