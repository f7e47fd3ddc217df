#pragma once

#include <vector>

namespace beadswim {

/// A node of a quadrature rule and its weight.
struct QuadratureNode {
  double place, weight;
};

/// Returns the Gauss-Legendre rule of `count` nodes on [from, to], by ascending place.
std::vector<QuadratureNode> gauss_legendre(int count, double from, double to);

}  // namespace beadswim
