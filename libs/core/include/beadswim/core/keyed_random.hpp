#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "beadswim/core/vec3.hpp"

namespace beadswim {

/// Random numbers that depend on a seed and keys alone, so that each swimmer's are the same whatever is done
/// to others, and on every machine (the standard's distributions are not). SplitMix64 (Steele, Lea and Flood
/// 2014).
class KeyedRandom {
 public:
  /// keys: whose, and what for.
  KeyedRandom(std::uint64_t seed, std::uint64_t key, std::uint64_t purpose)
      : state_(mixed(mixed(mixed(seed) ^ key) ^ purpose)) {}

  std::uint64_t bits() { return mixed(state_ += golden_gamma); }

  /// In [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// Of mean 0 and variance 1 (Box and Muller).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
  Vec3 normal3() {
    const double x = normal(), y = normal(), z = normal();
    return Vec3(x, y, z);
  }

  /// A unit vector, all directions alike.
  Vec3 direction() {
    const double z = 2 * uniform() - 1, angle = 2 * std::numbers::pi * uniform();
    const double rho = std::sqrt(1 - z * z);
    return Vec3(rho * std::cos(angle), rho * std::sin(angle), z);
  }

 private:
  static constexpr std::uint64_t golden_gamma = 0x9E3779B97F4A7C15;

  static constexpr std::uint64_t mixed(std::uint64_t z) {
    z += golden_gamma;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace beadswim
