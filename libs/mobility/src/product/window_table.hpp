#pragma once

#include <vector>

namespace beadswim {

// clang-format off
/// Window of a bead along one axis of a mesh: Kaiser-Bessel function of the shape b over P points, where x is the
/// position of a mesh point minus that of the bead [mesh spacing]. Its integral is 1:
///
///   W(x) = I_0(b sqrt(1 - (2 x/P)^2))/(P S(b^2)),   Fourier transform S(b^2 - (k P/2)^2)/S(b^2)
///
/// S: ewald_split.hpp. The values at the P points are polynomials of the position of the bead within a mesh cell.
// clang-format on
class WindowTable {
 public:
  static constexpr int max_points = 18, highest_derivative = 4;

  WindowTable() = default;
  WindowTable(int points, double shape);

  int points() const { return points_; }
  int degree() const { return degree_; }
  /// Returns the Fourier transform of the window, for the wavenumber `k` times the mesh spacing.
  double transform(double k) const;
  /// Returns the coefficients of the polynomials: [derivative][power][point], with the points padded with
  /// zeros to a multiple of 4. The variable goes from -1 to 1 while the first point goes from the distance
  /// -P/2 to 1 - P/2 from the bead.
  const double* polynomials() const { return polynomials_.data(); }

 private:
  int points_ = 0, degree_ = 0;
  double shape_ = 0;
  std::vector<double> polynomials_;
};

}  // namespace beadswim
