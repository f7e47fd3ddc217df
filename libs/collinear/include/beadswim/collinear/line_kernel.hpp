#pragma once

#include <complex>

// Values of flow kernels on a line along x. A kernel K(x_r, x_s) is the velocity along x at the receiver x_r,
// divided by the force along x at the source x_s. Units may be those of any coherent system.

namespace beadswim {

/// Value and derivatives of a kernel K(x_r, x_s): velocity at the receiver x_r per force at the source x_s.
template <class T>
struct LineKernel {
  T value{};        ///< K(x_r, x_s)
  T by_receiver{};  ///< dK / dx_r
  T by_source{};    ///< dK / dx_s
};

/// Value of a function of the displacement d = x_r - x_s from the source x_s of a flow to the receiver x_r,
/// and its derivative by d (slope). The kernels K(x_r, x_s) are composed of such functions.
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

/// Kernel of steady Stokes flow in two terms. G_xx is the velocity along x per point force along x. For two
/// spheres of radii a_i and a_j that do not overlap, the velocity of one sphere per force on the other is
/// oseen + (a_i^2 + a_j^2) laplacian.
struct SteadyFlow {
  LineKernel<double> oseen;      ///< G_xx [time/mass]
  LineKernel<double> laplacian;  ///< (1/6) laplacian of G_xx [time/(mass length^2)]
};

/// Kernel of unsteady Stokes flow at the angular frequency omega, with alpha^2 = i omega rho/eta (rho:
/// density, eta: dynamic viscosity of the fluid). The flow is the sum of a Helmholtz part and a harmonic
/// part. The radii of the spheres enter each part by a factor of its own (unsteady_sphere.hpp). For small
/// alpha the two parts nearly cancel, so their sum is evaluated separately.
struct UnsteadyFlow {
  LineKernel<std::complex<double>> helmholtz;  ///< decays with the distance r as exp(-alpha r) [time/mass]
  LineKernel<std::complex<double>> harmonic;   ///< potential flow [time/mass]
  LineKernel<std::complex<double>> total;  ///< helmholtz + harmonic, without loss of significance [time/mass]
};

}  // namespace beadswim
