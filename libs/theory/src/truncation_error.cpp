#include "beadswim/theory/truncation_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace beadswim {

namespace {

struct Reference {
  double separation_ratio;
  double excess;  ///< Rotne-Prager velocity over exact Stokes velocity, less 1
};

// Axisymmetric multipole solution of three equal spheres against Rotne-Prager, both to second order in
// amplitude: lambda = 4, k = 0.0347, eta = 1/3, T = 4800, A = B, alpha = pi/2. From T = 1000 to 10000 the
// excess at ratio 5 goes from 0.129 to 0.112.
constexpr std::array<Reference, 7> references{
    {{3, 0.613}, {4, 0.239}, {5, 0.118}, {6, 0.067}, {8, 0.028}, {10, 0.014}, {20, 0.002}}};

/// The power law through two references, at `ratio`.
double power_law(const Reference& from, const Reference& to, double ratio) {
  const double exponent =
      std::log(to.excess / from.excess) / std::log(to.separation_ratio / from.separation_ratio);
  return from.excess * std::pow(ratio / from.separation_ratio, exponent);
}

}  // namespace

double separation_ratio(const CollinearSwimmer& swimmer) {
  const auto ratio = [&](int arm) {
    return 2 * swimmer.arm[arm] / (swimmer.radius[arm] + swimmer.radius[arm + 1]);
  };
  return std::min(ratio(0), ratio(1));
}

std::optional<double> rotne_prager_over_exact(double separation_ratio) {
  if (separation_ratio < references.front().separation_ratio) return std::nullopt;
  auto upper = references.begin() + 1;
  while (upper + 1 != references.end() && upper->separation_ratio < separation_ratio) ++upper;
  return 1 + power_law(*(upper - 1), *upper, separation_ratio);
}

double finite_amplitude_change(const CollinearSwimmer& swimmer, const std::array<double, 2>& arm_amplitudes) {
  // Fits the change between small amplitude and A = 0.2 of the swimmer above at l = 20: 0.4, 1.1, 2.9 and
  // 4.3 % at T = 1000, 2000, 4800 and 10000.
  constexpr double coefficient = 0.3;
  const double swing_1 = arm_amplitudes[0] / swimmer.arm[0];
  const double swing_2 = arm_amplitudes[1] / swimmer.arm[1];
  return coefficient * (swing_1 * swing_1 + swing_2 * swing_2);
}

}  // namespace beadswim
