#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "beadswim/core/box.hpp"

// Lattice of the images of a force on a line along x, and its wavevectors. Walls act as mirrors: an axis with
// walls has twice the period, and mirrors in y and z add mirrored copies of the line. Mirrors in x are
// treated by LineFlow.

namespace beadswim {

/// A periodic lattice and a line in it.
struct PeriodicLine {
  /// A transverse axis with the positions of the copies of the line.
  struct Axis {
    double period = 0;  ///< [length]
    double mirror = 0;  ///< distance to the copy behind the wall at 0; 0: no wall [length]
  };
  /// A transverse wavevector (k_y, k_z).
  struct Wave {
    double square = 0;  ///< k_y^2 + k_z^2 [1/length^2]
    double weight = 0;  ///< sum of cos(k.d) over both signs of k_y and k_z and over all copies of the line
  };

  double period = 0;  ///< along x [length]
  Axis y, z;
  double splitting =
      0;  ///< xi of the Ewald sums [1/length]; waves up to about 12 xi, images up to about 6/xi

  double copies() const { return (y.mirror > 0 ? 2 : 1) * (z.mirror > 0 ? 2 : 1); }
  double volume() const { return period * y.period * z.period; }
};

/// Returns the lattice for the line at (y, z) [length] of a box, with the splitting that balances the work
/// for images and waves. Throws InputError as LineFlow does.
PeriodicLine periodic_line(const Box& box, double y, double z);

/// Returns the transverse wavevectors shorter than `longest` [1/length].
std::vector<PeriodicLine::Wave> transverse_waves(const PeriodicLine& line, double longest);

/// Returns the squared distances [length^2] from the line to its images nearer than `cutoff`. The line itself
/// (0) is included.
std::vector<double> image_lines(const PeriodicLine& line, double cutoff);

/// Calls visit(x, rho^2) for each image of the source nearer than `cutoff` to the receiver. (x, rho) is the
/// position of the receiver relative to the image; `displacement` is that relative to the source. An image at
/// distance 0 is left out.
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
