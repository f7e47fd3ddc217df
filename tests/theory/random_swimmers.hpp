#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "beadswim/theory/linear_response.hpp"
#include "swimmers.hpp"

namespace beadswim {

/// Random swimmers from a fixed seed: separations l/lambda from 2.6 to 50, radius ratios up to 4, arm ratios
/// up to 3 and more, any alpha, A/B from 0 to infinity with either sign. Every second swimmer has dashpots.
class RandomSwimmers {
 public:
  static constexpr std::uint64_t seed = 20170304;

  /// The values gamma omega / k of the arms are random numbers between the two arguments.
  RandomSwimmers(double softest_inverse, double softest) : least_(softest_inverse), most_(softest) {}

  CollinearSwimmer next() {
    CollinearSwimmer s;
    const double scale = log_uniform(0.1, 10);
    for (double& radius : s.radius) radius = scale * log_uniform(1, 4);
    s.density = {1, 1, 1};
    s.viscosity = log_uniform(0.01, 10);
    s.period = log_uniform(1, 1e4);
    s.phase = uniform(-std::numbers::pi, std::numbers::pi);
    const double separation = log_uniform(2.6, 50);
    const int longer = drawn_++ % 2;
    for (int arm = 0; arm < 2; ++arm) {
      const double touching = s.radius[arm] + s.radius[arm + 1];
      s.arm[arm] = separation * touching / 2 * (arm == longer ? log_uniform(1, 3) : 1);
      const double gamma = 3 * std::numbers::pi * s.viscosity * touching;
      s.stiffness[arm] = gamma * s.angular_frequency() / log_uniform(least_, most_);
      s.damping[arm] = drawn_ % 4 < 2 ? 0 : gamma * log_uniform(0.01, 3);
    }
    s.amplitude = drawn_amplitudes(s.stiffness[0] * s.arm[0] * 1e-3);
    return s;
  }

  double uniform(double least, double most) {
    return least + (most - least) * std::uniform_real_distribution<double>(0, 1)(generator_);
  }
  double log_uniform(double least, double most) { return std::exp(uniform(std::log(least), std::log(most))); }

 private:
  std::array<double, 2> drawn_amplitudes(double unit) {
    if (drawn_ % 10 == 3) return {unit, 0};
    if (drawn_ % 10 == 7) return {0, unit};
    const double ratio = log_uniform(1e-2, 1e2);
    return {unit, drawn_ % 3 == 0 ? -unit * ratio : unit * ratio};
  }

  double least_, most_;
  std::mt19937_64 generator_{seed};
  int drawn_ = 0;
};

/// Returns the swimmer with driving amplitudes for which the larger of the two ratios d_i/gap_i is `part`, to
/// first order and with Rotne-Prager mobility.
inline CollinearSwimmer driven_to(CollinearSwimmer s, double part) {
  const Stroke stroke = first_order_stroke(s, rotne_prager);
  double largest = 0;
  for (int arm = 0; arm < 2; ++arm) {
    largest = std::max(largest, stroke.amplitude[arm] / (s.arm[arm] - s.radius[arm] - s.radius[arm + 1]));
  }
  for (double& amplitude : s.amplitude) amplitude *= part / largest;
  return s;
}

}  // namespace beadswim
