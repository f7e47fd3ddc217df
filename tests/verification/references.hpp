#pragma once

#include <array>
#include <cmath>
#include <numbers>

// Reference values for the measurements.

namespace beadswim::verification {

constexpr double pi = std::numbers::pi;

/// Volume fraction of a simple-cubic array of spheres that touch, pi/6.
constexpr double touching_fraction = pi / 6;

/// Drag coefficient K of a simple-cubic array of volume fraction phi,
///
///   K = sum_{n=0}^{30} q_n chi^n,   chi = (phi/phi_max)^{1/3},   phi_max = pi/6
///
/// F = 6 pi eta R K U; F the force on a sphere with its share of the mean pressure gradient, U the
/// superficial velocity. Terms 21 to 30 add 3e-9, 1e-6, 7e-5, 2e-3 of K at phi = 0.027, 0.064, 0.125, 0.216.
///
/// Sangani and Acrivos, Int. J. Multiphase Flow 8 (1982) 343, eq. (60) and table 1. The coefficients
/// reproduce Zick and Homsy's K below to their last digit (1.6e-4 at phi = 0.216), and q_1 chi is Hasimoto's
/// 2.837297 R/L.
inline double cubic_array_drag(double phi) {
  constexpr std::array q{1.0,      1.418649, 2.012564,   2.331523,  2.564809,   2.584787,  2.873609,
                         3.340163, 3.536763, 3.504092,   3.253622,  2.689757,   2.037769,  1.809341,
                         1.877347, 1.534685, 0.9034708,  0.2857896, -0.5512626, -1.278724, 1.013350,
                         5.492491, 4.615388, -0.5736023, -2.865924, -4.709215,  -6.870076, 0.1455304,
                         12.51891, 9.742811, -5.566269};
  const double chi = std::cbrt(phi / touching_fraction);
  double sum = 0;
  for (std::size_t n = q.size(); n-- > 0;) sum = sum * chi + q[n];
  return sum;
}

/// Drag coefficients K of Zick and Homsy, J. Fluid Mech. 115 (1982) 13, table 2.
struct PrintedDrag {
  double phi, drag;
};
inline constexpr std::array zick_homsy{PrintedDrag{0.027, 2.008}, PrintedDrag{0.064, 2.810},
                                       PrintedDrag{0.125, 4.292}, PrintedDrag{0.216, 7.442}};

/// Returns K at low volume fraction by Hasimoto's series, J. Fluid Mech. 5 (1959) 317, with later terms by
/// Sangani and Acrivos (1982): 1/K = 1 - 1.7601 phi^{1/3} + phi - 1.5593 phi^2 + 3.9799 phi^{8/3} - 3.0734
/// phi^{10/3} + O(phi^{11/3}).
inline double dilute_array_drag(double phi) {
  return 1 / (1 - 1.7601 * std::cbrt(phi) + phi - 1.5593 * phi * phi + 3.9799 * std::pow(phi, 8.0 / 3) -
              3.0734 * std::pow(phi, 10.0 / 3));
}

/// Torque on each turning sphere of a cubic array over 8 pi eta R^3 Omega, 1/(1 - phi).
///
/// Each sphere turns with half the vorticity that its images make, besides its own T/(8 pi eta R^3). A
/// lattice of torques T (unit cell V) makes u = curl (psi T)/(2 eta) with laplacian psi = 1/V - sum of delta
/// functions; at a lattice point the images' part has d_i d_j psi = delta_ij/(3 V), so that their vorticity
/// is (grad div - laplacian)(psi T)/(2 eta) = -T/(3 eta V). Hence Omega = T/(8 pi eta R^3) - T/(6 eta V).
/// Images make no shear there, by symmetry; third derivatives add O(phi^{10/3}).
constexpr double array_torque(double phi) {
  return 1 / (1 - phi);
}

}  // namespace beadswim::verification
