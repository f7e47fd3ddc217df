#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <vector>

// Tables of line_map.hpp's S of two and of three spheres, exact mobilities by multipole_mobility.hpp.
//
// Lattice: u = log(gap/mean radius of the two), 0.125 apart, one axis a gap; between its nodes polynomials of
// degree 5 on the 6 nearest. A node is computed when it is first asked for, and is a function of its place
// alone: what is asked before, or by another rank, changes nothing.
//
// Gaps are held at the ends: above at 64 mean radii, where S - I is 1e-7; below where films are as thin as
// 0.02 radii of equal spheres, and unequal ones as near as takes no more multipoles: the larger one's
// bispherical coordinate xi has cosh xi - 1 = 0.01. Three spheres: 0.04 and 0.02.
//
// Page: docs/method/near-field.md.

namespace beadswim {

/// A smooth function of a few variables on a lattice that is filled as it is asked for.
template <int axes, int values>
class FilledLattice {
 public:
  using Place = std::array<double, axes>;
  using Values = std::array<double, values>;
  struct Axis {
    double first = 0;
    int nodes = 0;
  };
  static constexpr double spacing = 0.125;
  static constexpr int stencil = 6;

  FilledLattice(const std::array<Axis, axes>& extent, std::function<Values(const Place&)> law);

  /// Places off the lattice are held at its ends; no number is the lower end.
  Values at(const Place& place) const;

 private:
  const Values& node(const std::array<int, axes>& index) const;

  std::array<Axis, axes> extent_;
  std::function<Values(const Place&)> law_;
  mutable std::vector<std::optional<Values>> nodes_;
};

/// log S of two spheres. Any unit of length.
class PairMapTable {
 public:
  explicit PairMapTable(const std::array<double, 2>& radii);

  /// First row; the second is its opposite.
  Eigen::RowVector2d log_map(double gap) const;

 private:
  double mean_radius_;
  FilledLattice<1, 2> lattice_;
};

/// S - I of three spheres, 1 to 3 in their order along the line.
class TripletMapTable {
 public:
  explicit TripletMapTable(const std::array<double, 3>& radii);

  Eigen::Matrix3d change(const std::array<double, 2>& gaps) const;

 private:
  std::array<double, 2> mean_radii_;
  FilledLattice<2, 6> lattice_;
};

/// The thinnest film between two spheres of which cosh xi - 1 is at least `excess`.
double thinnest_film(double radius_i, double radius_j, double excess);

}  // namespace beadswim
