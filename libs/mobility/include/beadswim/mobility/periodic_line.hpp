#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "beadswim/core/box.hpp"

// Lattice of the images of a force on a line along x, and the wavevectors of this lattice. Walls act as
// mirrors. An axis with walls has twice the period of the box. Walls in y and z add mirror copies of the
// line. LineFlow treats walls in x.

namespace beadswim {

/// A periodic lattice and a line in it.
struct PeriodicLine {
  /// A transverse axis with the positions of the copies of the line.
  struct Axis {
    double period = 0;  ///< [length]
    double mirror = 0;  ///< distance to the copy behind the wall at 0 [length]; 0 if the axis has no walls
  };
  /// A transverse wavevector (k_y, k_z).
  struct Wave {
    double square = 0;  ///< k_y^2 + k_z^2 [1/length^2]
    /// Sum of cos(k.d) over both signs of k_y and k_z and over all copies of the line. d: from line to copy.
    double weight = 0;
  };

  double period = 0;  ///< along x [length]
  Axis y, z;
  /// xi of the Ewald sums [1/length], which include wavenumbers below 12.6 xi and images within 6.3/xi.
  double splitting = 0;

  double copies() const { return (y.mirror > 0 ? 2 : 1) * (z.mirror > 0 ? 2 : 1); }
  double volume() const { return period * y.period * z.period; }
};

/// Returns the lattice for the line at (y, z) [length] of a box. Its splitting balances the cost of images
/// and waves. Throws InputError if a length is not finite and positive, or if the line is not between the
/// walls.
PeriodicLine periodic_line(const Box& box, double y, double z);

/// Returns the transverse wavevectors shorter than `longest` [1/length], with k_y >= 0 and k_z >= 0.
std::vector<PeriodicLine::Wave> transverse_waves(const PeriodicLine& line, double longest);

/// Returns the squared distances [length^2] from the line to its images that are nearer than `cutoff`
/// [length]. The line itself is included, with distance 0.
std::vector<double> image_lines(const PeriodicLine& line, double cutoff);

/// Calls visit(x, rho^2) for each image of the source that is nearer than `cutoff` to the receiver. (x, rho)
/// is the vector from the image to the receiver, along and across the line. `displacement` is the vector from
/// the source to the receiver along the line. An image at the position of the receiver is left out.
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
