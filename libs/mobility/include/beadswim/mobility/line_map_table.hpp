#pragma once

#include <array>
#include <optional>
#include <vector>

#include "beadswim/mobility/line_map.hpp"

// Corrections S and tau of line_map.hpp for two and for three spheres on a line. M_r is the mobility by
// induced stresslets, strained_line(). A table contains the exact mobility M_x by multipole_mobility.hpp.
//
// Each axis of the table stands for the gap between two neighbouring spheres. The coordinate on the axis is
// u = log(gap/smallest gap). The nodes of the table are 0.125 apart in u. Values between the nodes are
// interpolated by polynomials of degree 5 through the 6 nearest nodes. A node is computed when it is first
// needed. Its value depends only on its position, so results do not depend on earlier calls or on the rank.
//
// A gap outside the table is replaced by the nearest gap in the table. The largest gap is 64 mean radii of
// the two spheres, where S - I is 1e-7. At the smallest gap, the bispherical coordinate xi of the larger
// sphere (min_tabulated_gap()) satisfies cosh xi - 1 = 0.01 for two spheres and 0.02 for three spheres. If
// the radii are equal, these smallest gaps are 0.02 and 0.04 radii.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// Table for N = 2 or 3 spheres, numbered in their order along the line. Radii and gaps are in the same unit
/// of length.
template <int N>
class LineMapTable {
 public:
  using Gaps = std::array<double, N - 1>;  ///< gap k is between the spheres k and k + 1

  explicit LineMapTable(const std::array<double, N>& radii);

  /// Returns S and tau for the viscosity 1 and the weight w of K in strained_line(). Between the smallest gap
  /// and overlap, tau decreases to 0.
  LineMap<N> at(Gaps gaps, double (*weight)(double));

 private:
  using Index = std::array<int, N - 1>;
  const LineMatrix<N>& node(const Index& index);
  LineMatrix<N> interpolated(const Gaps& gaps);

  std::array<double, N> radii_;
  Gaps min_gaps_;
  Index counts_;  ///< nodes on each axis
  /// Exact mobility, minus Rotne-Prager mobility, for the viscosity 1 [1/length].
  std::vector<std::optional<LineMatrix<N>>> nodes_;
};

/// Returns 1 for x up to `full`, 0 from `none`, and a decreasing function between them that is twice
/// continuously differentiable.
double fading(double x, double full, double none);

/// Returns the gap of two spheres [length] at which the bispherical coordinate xi of the larger sphere
/// satisfies cosh xi - 1 = excess. With the larger radius a_l, the smaller radius a_s and
/// R = gap + a_l + a_s:
///
///   cosh xi - 1 = gap (R - a_l + a_s) / (2 R a_l)
double min_tabulated_gap(double radius_i, double radius_j, double excess);

}  // namespace beadswim
