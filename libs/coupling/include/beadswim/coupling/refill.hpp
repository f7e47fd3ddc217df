#pragma once

#include <array>

#include "beadswim/core/vec3.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

// Populations of a cell that a bead has just uncovered, by Grad's thirteen-moment approximation.
//
//   f_i* = e_i(r, u) + 9/2 w_i (c_i.Q c_i - tr Q / 3) (1 - w+)
//   Q    = sum c_i c_i (f_i - e_i)        each pair i, ibar contributes twice the mean of its known values
//
// r: mean density deviation of the fluid around the cell; u: velocity of the bead at the cell; f_i:
// populations that have streamed into the cell from the surrounding fluid, as deviations from the weight w_i;
// e_i: equilibrium; w+: symmetric relaxation rate (trt.hpp); ibar: direction opposite to i; tr: trace.
// Lattice units, mean density 1.
//
// About half of the populations f_i are known. One known population of each pair i, ibar suffices, because Q
// is even in c. Nearly every pair has one. If every pair has one, the refill is exact in a linear shear flow.
// A refill with the equilibrium alone (Q = 0) is not exact in such a flow.
//
// Grad, Commun. Pure Appl. Math. 2 (1949) 331; as a refill: Dorschner, Chikatamarla, Boesch & Karlin, J.
// Comput. Phys. 295 (2015) 340.

namespace beadswim {

/// Populations that have streamed into an uncovered cell from the surrounding fluid. Only some directions are
/// known.
struct Arrivals {
  std::array<double, d3q19::directions> population;
  std::array<bool, d3q19::directions> is_known{};
};

/// Returns the tensor Q of the equation above, the second moment of f_i - e_i. The arguments are the known
/// populations f_i, the density deviation r and the velocity u.
inline Eigen::Matrix3d stress_of(const Arrivals& arrivals, double density_deviation, const Vec3& velocity) {
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
  for (int i = 1; i < d3q19::directions; i += 2) {
    double sum = 0;
    int known = 0;
    for (const int j : {i, d3q19::opposite(i)}) {
      if (!arrivals.is_known[j]) continue;
      sum +=
          arrivals.population[j] - equilibrium(j, density_deviation, velocity[0], velocity[1], velocity[2]);
      ++known;
    }
    if (known == 0) continue;
    const Vec3 c = velocity_of(i);
    stress += 2 * sum / known * c * c.transpose();
  }
  return stress;
}

/// Returns the population f_i* of the refilled cell by the equation above. stress: Q; decay: 1 - w+, where w+
/// is the symmetric relaxation rate.
inline double refilled(int i, double density_deviation, const Vec3& velocity, const Eigen::Matrix3d& stress,
                       double decay) {
  const Vec3 c = velocity_of(i);
  return equilibrium(i, density_deviation, velocity[0], velocity[1], velocity[2]) +
         4.5 * d3q19::weight(i) * (c.dot(stress * c) - stress.trace() / 3) * decay;
}

}  // namespace beadswim
