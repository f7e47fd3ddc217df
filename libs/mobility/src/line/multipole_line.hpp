#pragma once

#include <span>
#include <vector>

#include "multipole_sphere.hpp"

// Spheres on a line, each with as many multipoles as its neighbours make necessary.

namespace beadswim::multipole {

/// The unknowns of sphere i start at row start[i] of the whole system; start has one entry more.
struct Line {
  std::span<const double> radius, position;  ///< [length]
  std::vector<Sphere> sphere;
  std::vector<int> start;

  int size() const { return static_cast<int>(radius.size()); }
  int unknowns() const { return start.back(); }
  int largest_order() const;
  Pair pair(int receiver, int source) const;
};

/// Orders for an error near exp(log_tolerance) by experience. Throws InputError beyond
/// largest_multipole_order.
Line line_for(std::span<const double> radii, std::span<const double> positions, double log_tolerance);

/// xi of sphere i in the bispherical coordinates that it shares with its nearest neighbour: what it mirrors
/// of the others lies within a_i exp(-xi) of its centre, so that its multipoles of order n fall as exp(-n
/// xi). Infinite for a lone sphere.
double nearest_coordinate(const Line& line, int i);

}  // namespace beadswim::multipole
