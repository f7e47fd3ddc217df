#pragma once

#include <span>
#include <vector>

#include "multipole_sphere.hpp"

// Spheres on a line, with the number of multipoles that the distance to their neighbours requires.

namespace beadswim::multipole {

/// The unknowns of sphere i start at row start[i] of the linear system. `start` has one additional entry, the
/// end.
struct Line {
  std::span<const double> radius, position;  ///< [length]
  std::vector<Sphere> sphere;
  std::vector<int> start;

  int size() const { return static_cast<int>(radius.size()); }
  int unknowns() const { return start.back(); }
  int largest_order() const;
  Pair pair(int receiver, int source) const;
};

/// Sets up the spheres with orders for an error near exp(log_tolerance), by an empirical estimate. Throws
/// InputError if an order exceeds max_multipole_order.
Line make_line(std::span<const double> radii, std::span<const double> positions, double log_tolerance);

/// Returns the bispherical coordinate xi of sphere i with respect to its nearest neighbour. The images of the
/// other spheres in sphere i lie within a_i exp(-xi) of its centre, so its multipoles of order n decay as
/// exp(-n xi). Infinite for a lone sphere.
double nearest_bispherical_coordinate(const Line& line, int i);

}  // namespace beadswim::multipole
