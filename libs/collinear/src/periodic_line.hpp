#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "beadswim/collinear/line_kernel.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/core/complex.hpp"

// Periodic lattice of the images of a force along x on a line parallel to x in a box, and the wavevectors of
// this lattice. Ewald sums of the flow on the line use both (periodic_flow.hpp).
//
// Free-slip walls act as mirrors. The period of an axis with walls is twice the edge of the box. If y or z
// has walls, the lattice contains mirror copies of the line with equal forces. Mirror images behind walls in
// x are not part of the lattice; line_flow.hpp adds their flow.

namespace beadswim {

/// Gaussian factors below exp(-6.3^2) = 6e-18 are neglected in Ewald sums.
constexpr double gaussian_cutoff = 6.3;

/// Line along x in a periodic lattice, with mirror copies of the line behind walls in y and z.
struct PeriodicLine {
  /// Axis y or z of the lattice, with the position of the mirror copy of the line along this axis.
  struct Axis {
    double period = 0;  ///< [length]
    double mirror = 0;  ///< distance from line to mirror copy behind the wall at 0 [length]; 0: no walls
  };
  /// Wavevectors (k_y, k_z) perpendicular to the line. One object represents both signs of k_y and of k_z.
  struct Wave {
    double square = 0;  ///< k_y^2 + k_z^2 [1/length^2]
    /// Sum of cos(k.d) over both signs of k_y and k_z, and over the line and its mirror copies. d is the
    /// vector from the line to the copy, and 0 for the line itself.
    double weight = 0;
  };

  double period = 0;  ///< along x [length]
  Axis y, z;
  double splitting = 0;  ///< parameter xi of the Ewald sums [1/length]

  /// Returns the wavenumber up to which waves are summed [1/length], and the distance up to which images are
  /// summed [length].
  double max_wavenumber() const { return 2 * gaussian_cutoff * splitting; }
  double image_cutoff() const { return gaussian_cutoff / splitting; }
  double wave_spacing() const { return 2 * std::numbers::pi / period; }  ///< of k_x [1/length]

  double copies() const { return (y.mirror > 0 ? 2 : 1) * (z.mirror > 0 ? 2 : 1); }
  double volume() const { return period * y.period * z.period; }
};

/// Returns the lattice of the images of a force on the line along x through (y, z) in the box [length]. Its
/// splitting parameter balances the costs of the sums over images and over wavevectors. Throws InputError if
/// an edge of the box is not finite and positive, or if the line is not between the walls.
PeriodicLine periodic_line(const Box& box, double y, double z);

/// Returns the wavevectors (k_y, k_z) perpendicular to the line that are shorter than max_wavenumber(). Only
/// those with k_y >= 0 and k_z >= 0 are listed; their weights include the other signs.
std::vector<PeriodicLine::Wave> transverse_waves(const PeriodicLine& line);

/// Two functions of the displacement d along the line, as sums of amplitude_n cos(k_x d) over the wavenumbers
/// k_x = 2 pi n/period, n = 0, 1, ...
template <class T>
using WaveAmplitudes = std::vector<std::array<T, 2>>;

/// Returns amplitudes that are sums over all wavevectors (k_y, k_z) with k = |(k_x, k_y, k_z)| up to
/// max_wavenumber(). add(amplitudes, wave, k^2) adds the terms of one wavevector to the two amplitudes.
template <class T, class Add>
WaveAmplitudes<T> sum_over_transverse_waves(const PeriodicLine& line, const Add& add) {
  const double longest = line.max_wavenumber();
  const auto waves = transverse_waves(line);
  WaveAmplitudes<T> amplitudes;
  for (int n = 0; n * line.wave_spacing() < longest; ++n) {
    const double k_x = n * line.wave_spacing();
    amplitudes.emplace_back();
    for (const auto& wave : waves) {
      const double k2 = k_x * k_x + wave.square;
      if (k2 <= longest * longest) add(amplitudes.back(), wave, k2);
    }
  }
  return amplitudes;
}

/// Evaluates the two functions at a displacement along the line.
template <class T>
std::array<LineKernel<T>, 2> sum_over_waves(const WaveAmplitudes<T>& amplitudes, const PeriodicLine& line,
                                            double displacement) {
  const Complex step = std::polar(1.0, line.wave_spacing() * displacement);
  Complex phase = 1;
  std::array<LineKernel<T>, 2> sum;
  double k = 0;
  for (const auto& [first, second] : amplitudes) {
    const auto shape = displacement_kernel(phase.real(), -k * phase.imag());
    sum[0] += first * shape;
    sum[1] += second * shape;
    phase *= step;
    k += line.wave_spacing();
  }
  return sum;
}

/// Returns the squared distances [length^2] from the line to its periodic and mirror images that are nearer
/// than `cutoff` [length]. The line itself is included, with distance 0.
std::vector<double> image_lines(const PeriodicLine& line, double cutoff);

/// Calls visit(x, rho^2) for each image of a source on the line that is nearer than `cutoff` to a receiver on
/// the line. (x, rho) is the vector from the image to the receiver, along and across the line. An image at
/// the position of the receiver is left out. Arguments:
///
///   period        period of the lattice along the line [length]
///   image_lines   squared distances from the line to its images [length^2]
///   displacement  displacement along the line from the source to the receiver [length]
template <class Visitor>
void for_each_image(double period, const std::vector<double>& image_lines, double cutoff, double displacement,
                    const Visitor& visit) {
  for (const double rho2 : image_lines) {
    const double half = std::sqrt(std::max(0.0, cutoff * cutoff - rho2));
    const double last = std::floor((half - displacement) / period);
    for (double n = std::ceil((-half - displacement) / period); n <= last; ++n) {
      const double x = displacement + n * period;
      if (x != 0 || rho2 != 0) visit(x, rho2);
    }
  }
}

}  // namespace beadswim
