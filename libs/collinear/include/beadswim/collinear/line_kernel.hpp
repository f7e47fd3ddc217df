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

  LineKernel& operator+=(const LineKernel& other) {
    value += other.value;
    by_receiver += other.by_receiver;
    by_source += other.by_source;
    return *this;
  }
};

template <class Factor, class T>
auto operator*(const Factor& factor, const LineKernel<T>& term) {
  return LineKernel<decltype(factor * term.value)>{factor * term.value, factor * term.by_receiver,
                                                   factor * term.by_source};
}

/// Returns the kernel K(x_r, x_s) = f(x_r - x_s) of fluid without walls across the line. `value` and `slope`
/// are f and its derivative at the displacement x_r - x_s from the source to the receiver.
template <class T>
LineKernel<T> displacement_kernel(const T& value, const T& slope) {
  return {.value = value, .by_receiver = slope, .by_source = -slope};
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
