#pragma once

#include <complex>

// What flow kernels on a line along x answer: the velocity along x at the receiver x_r by a unit force along
// x at the source x_s. Any coherent unit system.

namespace beadswim {

/// A function of receiver and source, and its derivatives by either.
template <class T>
struct LineKernel {
  T value{};        ///< K(x_r, x_s)
  T by_receiver{};  ///< dK / dx_r
  T by_source{};    ///< dK / dx_s
};

/// A function of the displacement d = x_r - x_s alone, and its slope. The blocks that kernels are made of.
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

/// Steady Stokes flow: spheres of radii a_i and a_j apart from each other interact by
/// oseen + (a_i^2 + a_j^2) laplacian.
struct SteadyFlow {
  LineKernel<double> oseen;      ///< G_xx [time/mass]
  LineKernel<double> laplacian;  ///< (1/6) laplacian of G_xx [time/(mass length^2)]
};

/// Unsteady Stokes flow of frequency omega, alpha^2 = i omega rho / eta: spheres' sizes multiply its two
/// parts by different factors (unsteady_sphere.hpp). The parts nearly cancel for small alpha, so their sum
/// comes too.
struct UnsteadyFlow {
  LineKernel<std::complex<double>> helmholtz;  ///< the part that decays as exp(-alpha r) [time/mass]
  LineKernel<std::complex<double>> harmonic;   ///< the potential flow [time/mass]
  LineKernel<std::complex<double>> whole;      ///< helmholtz + harmonic, without cancellation [time/mass]
};

}  // namespace beadswim
