#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/mobility/near_map.hpp"

// clang-format off
// Strains of beads by the forces on close beads, for K_ij = w_ij D_i^-1 (M_HF)_ij of near_map.hpp. Open space: a force
// F at the distance r, e the unit vector away from it, causes the symmetric, traceless part of
//
//   e (2 p F + q (e.F) e)^T,    p = r (L_1/2 - X_2),  q = -r^3 X_3
//
//   X    function chi of the Oseen tensor for both spheres, L its Laplacian, divided by 8 pi eta
//   X_n  ((1/r) d/dr)^n X (moment_radials.hpp)
//
// Spheres of radii a (strained) and b that do not overlap:
//
//   8 pi eta p = -6 c/r^4,   8 pi eta q = -3/r^2 + 30 c/r^4,   c = a^2/10 + b^2/6
//
// M_HF and D contain the flow that the wall of a half-space reflects, with the weight pair_weight(s/2), where s is
// the distance of bead i and the mirror point of bead j. So a force also strains its own bead.
// clang-format on

namespace beadswim {

class NearStrains {
 public:
  /// Prepares add() for beads at `positions` [length]. Adds D_i^-1 and the links of each bead alone over the
  /// wall to `links`.
  NearStrains(std::span<const double> radii, double viscosity, const std::optional<HalfSpace>& half_space,
              std::span<const Vec3> positions, NearLinks& links);

  /// Adds the strains of `bead` and `partner` by the forces on each other, or of `bead` by the force on an
  /// image of the partner.
  ///   separation  position of the bead minus that of the partner, or of the image [length]
  ///   mirror      sign of each component of the force on the image
  ///   weight      w
  void add(int bead, int partner, const Vec3& separation, bool is_image, const Vec3& mirror, double weight);

 private:
  Eigen::Matrix<double, 8, Eigen::Dynamic> reflected_flow(int i, int j, int moments) const;
  void add_over_wall(int bead);
  void add_reflected(int strained, int forced, double weight);

  std::span<const double> radii_;
  double viscosity_;
  std::optional<HalfSpace> half_space_;
  std::vector<Vec3> positions_;  ///< raised to min_wall_height
  NearLinks& links_;
};

}  // namespace beadswim
