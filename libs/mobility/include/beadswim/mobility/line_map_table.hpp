#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <vector>

// Tables of the matrix S of line_map.hpp for two and for three spheres on a line. If S maps the forces on the
// spheres and S^T the velocities that follow with the Rotne-Prager mobility, the resulting velocities are
// exact for forces that sum to zero. The exact mobility is evaluated by multipole_mobility.hpp.
//
// Each axis of a table stands for the gap between two neighbouring spheres. The coordinate on the axis is
// u = log(gap/mean radius of the two spheres). The nodes of the table are 0.125 apart in u. Values between
// the nodes are interpolated by polynomials of degree 5 through the 6 nearest nodes. A node is computed when
// it is first needed. Its value depends only on its position, so results do not depend on earlier calls or on
// the rank.
//
// A gap outside the table is replaced by the nearest gap in the table. The largest gap is 64 mean radii,
// where S - I is 1e-7. At the smallest gap, the bispherical coordinate xi of the larger sphere
// (min_tabulated_gap()) satisfies cosh xi - 1 = 0.01 for two spheres and 0.02 for three spheres. If the radii
// are equal, these smallest gaps are 0.02 and 0.04 radii.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// Interpolation table of a smooth function with `axes` arguments and `values` components. The function is
/// evaluated at a node of the table when the node is first needed.
template <int axes, int values>
class LazyTable {
 public:
  using Place = std::array<double, axes>;
  using Values = std::array<double, values>;
  struct Axis {
    double first = 0;  ///< coordinate of the first table node
    int nodes = 0;     ///< number of table nodes
  };
  static constexpr double spacing = 0.125;  ///< distance of neighbouring table nodes
  static constexpr int stencil = 6;         ///< table nodes per axis that one interpolation uses

  LazyTable(const std::array<Axis, axes>& extent, std::function<Values(const Place&)> law);

  /// Returns the interpolated values of the function at the point with the coordinates `place`. A coordinate
  /// outside the table is replaced by the nearest end of its axis, NaN by the lower end.
  Values at(const Place& place) const;

 private:
  const Values& node(const std::array<int, axes>& index) const;

  std::array<Axis, axes> extent_;
  std::function<Values(const Place&)> law_;
  mutable std::vector<std::optional<Values>> nodes_;
};

/// Table of the matrix logarithm log S for two spheres. S is the 2 x 2 matrix that corrects the Rotne-Prager
/// mobility of the spheres along their line (line_map.hpp). Radii and gaps are in the same unit of length.
class PairMapTable {
 public:
  explicit PairMapTable(const std::array<double, 2>& radii);

  /// Returns the first row of the 2 x 2 matrix log S for the distance `gap` of the two surfaces. The second
  /// row of log S is minus the first row.
  Eigen::RowVector2d log_map(double gap) const;

 private:
  double mean_radius_;
  LazyTable<1, 2> table_;
};

/// Table of S - I for three spheres, numbered in their order along the line. S is the 3 x 3 matrix that
/// corrects the Rotne-Prager mobility of the spheres along their line (line_map.hpp), I the unit matrix.
/// Radii and gaps are in the same unit of length.
class TripletMapTable {
 public:
  explicit TripletMapTable(const std::array<double, 3>& radii);

  /// Returns the 3 x 3 matrix S - I. gaps[0] is the gap between spheres 1 and 2, gaps[1] the gap between
  /// spheres 2 and 3.
  Eigen::Matrix3d change(const std::array<double, 2>& gaps) const;

 private:
  std::array<double, 2> mean_radii_;
  LazyTable<2, 6> table_;
};

/// Returns the gap of two spheres [length] at which the bispherical coordinate xi of the larger sphere
/// satisfies cosh xi - 1 = excess. With the larger radius a_l, the smaller radius a_s and
/// R = gap + a_l + a_s:
///
///   cosh xi - 1 = gap (R - a_l + a_s) / (2 R a_l)
double min_tabulated_gap(double radius_i, double radius_j, double excess);

}  // namespace beadswim
