#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/complex.hpp"
#include "beadswim/plan/lattice_lag.hpp"

namespace beadswim {
namespace {

constexpr double pi = std::numbers::pi;

double shell(double wave_times_radius) {
  return wave_times_radius == 0 ? 1 : std::sin(wave_times_radius) / wave_times_radius;
}

/// Returns the integral of (sin(ka)/(ka))^2 over k from `first` to infinity [1/length]. The integral from 0
/// is pi/(2a). a: `radius`.
double shell_integral_from(double first, double radius) {
  constexpr int points = 400;
  double below = 0;
  for (int n = 0; n < points; ++n) {
    const double wave = (n + 0.5) * first / points;
    below += std::pow(shell(wave * radius), 2) * first / points;
  }
  return pi / (2 * radius) - below;
}

/// Wavevectors of a periodic box. Free-slip walls are replaced by mirror images in a box of twice the length.
struct Waves {
  Waves(const BoxPlace& place, double shortest_radius) : place(place), lengths(mirrored_lengths(place.box)) {
    const double volume = lengths[0] * lengths[1] * lengths[2];
    constexpr double max_waves = 2e5, shells = 6;
    cut = std::min(shells / shortest_radius, std::cbrt(6 * pi * pi * max_waves / volume));
  }

  int count(int axis) const { return static_cast<int>(cut * lengths[axis] / (2 * pi)); }
  double wave(int axis, int n) const { return 2 * pi * n / lengths[axis]; }
  double volume() const { return lengths[0] * lengths[1] * lengths[2]; }

  /// Returns the factor by which the mirror images at walls normal to `axis` (y or z) change a wave.
  double mirror_factor(int axis, double wave) const {
    return place.box.has_mirrors(axis) ? 1 + std::cos(2 * wave * place.middle_bead[axis]) : 1;
  }

  const BoxPlace& place;
  Vec3 lengths;
  double cut = 0;  ///< largest wavenumber [1/length]
};

}  // namespace

SoundFlow sound_flow(const InertialScene& scene, const std::optional<BoxPlace>& place, double sound_speed) {
  const auto& radius = scene.swimmer.radius;
  const double omega = scene.swimmer.angular_frequency(), rho = scene.fluid_density;
  const double nu = scene.swimmer.viscosity / rho;
  SoundFlow flow{.value = Eigen::Matrix3cd::Zero(), .by_receiver = Eigen::Matrix3cd::Zero()};
  const auto add_self_flow = [&](double from_wave) {
    for (int i = 0; i < 3; ++i) {
      flow.value(i, i) += i_unit * omega * shell_integral_from(from_wave, radius[i]) /
                          (6 * pi * pi * rho * sound_speed * sound_speed);
    }
  };
  if (!place) {
    add_self_flow(0);
    return flow;
  }
  const Waves waves(*place, *std::ranges::min_element(radius));
  const bool walls_across = place->box.has_mirrors(0);
  for (int nx = 1; nx <= waves.count(0); ++nx) {
    const double kx = waves.wave(0, nx);
    // Sum over all waves with this k_x. Element (j, i) contains the form factors of beads j and i, which
    // depend on |k| and on the bead radii.
    Eigen::Matrix3cd amplitude = Eigen::Matrix3cd::Zero();
    for (int ny = 0; ny <= waves.count(1); ++ny) {
      const double ky = waves.wave(1, ny);
      for (int nz = 0; nz <= waves.count(2); ++nz) {
        const double kz = waves.wave(2, nz);
        const double k2 = kx * kx + ky * ky + kz * kz, k = std::sqrt(k2);
        if (k > waves.cut) break;
        const double multiplicity = 2 * (ny > 0 ? 2 : 1) * (nz > 0 ? 2 : 1);  // both signs of k_x, k_y, k_z
        const Complex denominator =
            sound_speed * sound_speed * k2 - omega * omega + 2.0 * i_unit * omega * nu * k2;
        const Complex term = multiplicity / waves.volume() * waves.mirror_factor(1, ky) *
                             waves.mirror_factor(2, kz) * (kx * kx / k2) * i_unit * omega /
                             (rho * denominator);
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i) amplitude(j, i) += term * shell(k * radius[j]) * shell(k * radius[i]);
      }
    }
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        const double distance = scene.positions[j] - scene.positions[i];
        const double mirror_distance = scene.positions[j] + scene.positions[i];
        flow.value(j, i) +=
            amplitude(j, i) * (std::cos(kx * distance) - (walls_across ? std::cos(kx * mirror_distance) : 0));
        flow.by_receiver(j, i) -=
            kx * amplitude(j, i) *
            (std::sin(kx * distance) - (walls_across ? std::sin(kx * mirror_distance) : 0));
      }
    }
  }
  add_self_flow(waves.cut);
  return flow;
}

}  // namespace beadswim
