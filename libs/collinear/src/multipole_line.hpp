#pragma once

#include <span>
#include <vector>

#include "multipole_sphere.hpp"

// Spheres on a line for the multipole expansion of their flow. The number of multipoles of each sphere
// follows from the distances to its neighbours.

namespace beadswim::multipole {

/// Spheres on a line and the layout of the linear system for their multipole coefficients. The unknowns of
/// sphere i start at row start[i]. The last entry of `start` is the number of rows.
struct Line {
  std::span<const double> radius, position;  ///< [length]
  std::vector<Sphere> sphere;
  std::vector<int> start;

  int size() const { return static_cast<int>(radius.size()); }
  int unknowns() const { return start.back(); }
  int largest_order() const;
  Pair pair(int receiver, int source) const;
};

/// Sets up spheres with the radii and the positions along the line [length]. The multipole orders follow from
/// an empirical estimate for a relative error of the mobility near exp(log_tolerance). Throws InputError if
/// an order exceeds max_multipole_order.
Line make_line(std::span<const double> radii, std::span<const double> positions, double log_tolerance);

/// Returns the bispherical coordinate xi of sphere i relative to its nearest neighbour, or infinity for a
/// lone sphere. All image points of the other spheres, reflected into sphere i, lie within a_i exp(-xi) of
/// its centre, where a_i is its radius. The multipoles of sphere i therefore decay with the order n as
/// exp(-n xi).
double nearest_bispherical_coordinate(const Line& line, int i);

}  // namespace beadswim::multipole
