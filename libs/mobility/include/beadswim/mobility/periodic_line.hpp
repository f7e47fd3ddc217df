#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "beadswim/core/box.hpp"

// The lattice of images of a force on a line along x, and the waves of the same lattice. Walls are taken as
// mirrors, so axes with walls have twice the period and y and z bring mirrored copies of the line itself;
// mirrors in x are left to LineFlow.

namespace beadswim {

/// A lattice seen from a line in it.
struct PeriodicLine {
  /// One transverse axis: the place of the line's copies on it.
  struct Axis {
    double period = 0;
    double mirror = 0;  ///< distance to the copy behind the wall at 0; none if 0
  };
  /// A transverse wavevector (k_y, k_z): its square and the sum of cos(k.d) over both signs and all copies.
  struct Wave {
    double square = 0;
    double weight = 0;
  };

  double period = 0;  ///< along x [length]
  Axis y, z;
  double splitting = 0;  ///< xi of the Ewald sums [1/length]: waves up to about 12 xi, images up to 6/xi

  double copies() const { return (y.mirror > 0 ? 2 : 1) * (z.mirror > 0 ? 2 : 1); }
  double volume() const { return period * y.period * z.period; }
};

/// The lattice for the line at (y, z) of a box, with the splitting that balances images and waves. Throws
/// InputError as LineFlow does.
PeriodicLine periodic_line(const Box& box, double y, double z);

/// Transverse wavevectors shorter than `longest` [1/length].
std::vector<PeriodicLine::Wave> transverse_waves(const PeriodicLine& line, double longest);

/// Squared distances from the line of its images nearer than `reach`, itself (0) included [length^2].
std::vector<double> image_lines(const PeriodicLine& line, double reach);

/// Calls visit(x, rho^2) with the place of the receiver as seen from each image of the source nearer than
/// `reach`, for a receiver at `displacement` from the source; an image at distance 0 is left out.
template <class Visitor>
void for_each_image(double period, const std::vector<double>& image_lines, double reach, double displacement,
                    const Visitor& visit) {
  for (const double rho2 : image_lines) {
    const double half = std::sqrt(std::max(0.0, reach * reach - rho2));
    const double last = std::floor((half - displacement) / period);
    for (double n = std::ceil((-half - displacement) / period); n <= last; ++n) {
      const double x = displacement + n * period;
      if (x != 0 || rho2 != 0) visit(x, rho2);
    }
  }
}

}  // namespace beadswim
