#pragma once

#include <span>
#include <vector>

namespace beadswim {

/// A point of the half-plane (x, s) with the weight of its ring around the line: x along the line, s distance
/// from it [length], weight [length^3].
struct RingNode {
  double x, s, weight;
};

/// Returns nodes and weights of a quadrature over all space outside of the spheres on the line. Planes in the
/// middle of the gaps divide space into one region per sphere. In each region, composite Gauss rules in the
/// cosine of the polar angle and in the distance r from the centre have `count` nodes per panel. The widths
/// of the radial panels double from the smallest of radius, gap (at least 0.01 radii) and `depth` [length],
/// the penetration depth of the flow. Integrands must decay at least as r^-4.
std::vector<RingNode> outside_nodes(std::span<const double> radii, std::span<const double> positions,
                                    double depth, int count);

}  // namespace beadswim
