#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <vector>

// Tables of the map S of line_map.hpp for two and for three spheres. Exact mobilities are evaluated by
// multipole_mobility.hpp.
//
// Each axis of a table is one gap, in the coordinate u = log(gap/mean radius of the two spheres), with nodes
// 0.125 apart. Values between the nodes are interpolated by polynomials of degree 5 through the 6 nearest
// nodes. A node is computed when it is first needed. Its value depends only on its position, so results do
// not depend on earlier calls or on the rank.
//
// Gaps beyond the ends of a table are replaced by the gaps at the ends. The upper end is at 64 mean radii,
// where S - I is 1e-7. The lower end is where the bispherical coordinate xi of the larger sphere has cosh xi
// - 1 = 0.01, or 0.02 for three spheres. For equal spheres this gap is 0.02 radii, or 0.04 radii for three
// spheres.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// Interpolates a smooth function of a few variables. Function values at the nodes are computed on demand.
template <int axes, int values>
class LazyTable {
 public:
  using Place = std::array<double, axes>;
  using Values = std::array<double, values>;
  struct Axis {
    double first = 0;  ///< coordinate of the first node
    int nodes = 0;     ///< number of nodes
  };
  static constexpr double spacing = 0.125;
  static constexpr int stencil = 6;  ///< nodes per interpolation and axis

  LazyTable(const std::array<Axis, axes>& extent, std::function<Values(const Place&)> law);

  /// Interpolates. A coordinate outside the table is replaced by the nearest end, NaN by the lower end.
  Values at(const Place& place) const;

 private:
  const Values& node(const std::array<int, axes>& index) const;

  std::array<Axis, axes> extent_;
  std::function<Values(const Place&)> law_;
  mutable std::vector<std::optional<Values>> nodes_;
};

/// Table of log S for two spheres. Any unit of length.
class PairMapTable {
 public:
  explicit PairMapTable(const std::array<double, 2>& radii);

  /// Returns the first row of log S at a gap. The second row is its negative.
  Eigen::RowVector2d log_map(double gap) const;

 private:
  double mean_radius_;
  LazyTable<1, 2> table_;
};

/// Table of S - I for three spheres, numbered in their order along the line. Any unit of length.
class TripletMapTable {
 public:
  explicit TripletMapTable(const std::array<double, 3>& radii);

  /// Returns S - I at the gaps of spheres 1 and 2 and of spheres 2 and 3.
  Eigen::Matrix3d change(const std::array<double, 2>& gaps) const;

 private:
  std::array<double, 2> mean_radii_;
  LazyTable<2, 6> table_;
};

/// Returns the gap of two spheres at which the bispherical coordinate xi of the larger one has
/// cosh xi - 1 = excess [length].
double min_tabulated_gap(double radius_i, double radius_j, double excess);

}  // namespace beadswim
