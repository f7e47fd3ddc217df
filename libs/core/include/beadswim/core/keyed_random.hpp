#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Increment of the state of SplitMix64 (Steele, Lea and Flood 2014): 2^64 divided by the golden ratio.
constexpr std::uint64_t golden_gamma = 0x9E3779B97F4A7C15;

/// Returns the mixing function of SplitMix64: each bit of the result depends on all bits of z.
constexpr std::uint64_t mix_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

/// Random number generator whose sequence depends only on a seed and two keys (`key` and `purpose` below). If
/// `key` is the id of a swimmer, the random numbers of this swimmer do not depend on other swimmers. The
/// numbers are equal on all machines, which the distributions of the C++ standard library do not guarantee.
/// Generator: SplitMix64.
class KeyedRandom {
 public:
  /// `key` identifies the object, for example a swimmer. `purpose` distinguishes several sequences of the
  /// same object.
  KeyedRandom(std::uint64_t seed, std::uint64_t key, std::uint64_t purpose)
      : state_(next(next(next(seed) ^ key) ^ purpose)) {}

  std::uint64_t bits() { return next(state_ += golden_gamma); }

  /// Returns a uniformly distributed number in [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// Returns a normally distributed number of mean 0 and variance 1 (Box and Muller).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
  /// Returns two independent numbers as normal(), in about the time of one.
  std::pair<double, double> normal_pair() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform())), angle = 2 * std::numbers::pi * uniform();
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }
  Vec3 normal3() {
    const double x = normal(), y = normal(), z = normal();
    return Vec3(x, y, z);
  }

  /// Returns an isotropically distributed unit vector.
  Vec3 direction() {
    const double z = 2 * uniform() - 1, angle = 2 * std::numbers::pi * uniform();
    const double rho = std::sqrt(1 - z * z);
    return Vec3(rho * std::cos(angle), rho * std::sin(angle), z);
  }

 private:
  static constexpr std::uint64_t next(std::uint64_t z) { return mix_bits(z + golden_gamma); }

  std::uint64_t state_;
};

}  // namespace beadswim
