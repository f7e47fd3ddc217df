#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/mobility.hpp"

// Root B of a mobility, B B^T = mu, applied to normally distributed numbers z. The velocities sqrt(2 kT/h) B
// z are the thermal noise of a time step h. For few spheres in open space, B is the Cholesky factor
// of mu. Otherwise, the root is found by products alone (method of Lanczos):
//
//   M^(1/2) z = |z| V T^(1/2) e_1,   M = S^-1 mu S^-1,   B z = S M^(1/2) z
//
//   S  diagonal matrix, close to the root of the diagonal of mu
//   V  orthonormal basis of z, M z, M^2 z, ...;  T = V^T M V;  e_1: first unit vector
//
// By domain and model, mu is one of these:
//
//   box, forces alone  near part of an Ewald sum whose parts are both positive (ewald_split.hpp). The far
//                      part is a diagonal matrix of wavevectors: its root needs one inverse transform
//   force moments      grand mobility G: the flow with its noise (u_F, u_H) gives free spheres the velocities
//                      u_F - M_FH M_HH^-1 u_H, whose covariance is M_FF - M_FH M_HH^-1 M_HF
//   else               the whole mobility
//
// References: Chow and Saad, SIAM J. Sci. Comput. 36, A588 (2014); Fiore, Balboa Usabiaga, Donev and Swan, J.
// Chem. Phys. 146, 124116 (2017). Page: docs/method/thermal-noise.md.

namespace beadswim {

/// Velocities B z of all spheres, and how they were found.
struct RootProduct {
  std::vector<Vec3> velocities;
  ProductWork work{};
  double error = 0;  ///< norm of the last change of M^(1/2) z, divided by that of M^(1/2) z
  /// false if the error did not fall below the tolerance, or if the mobility is not positive
  bool is_converged = true;
};

class GrandMobility;

class MobilityRoot {
 public:
  /// Root of the mobility of the scene. `tolerance`: accepted error of B z, divided by its norm. `positions`
  /// and errors: as of Mobility. `mobility`: of the same scene; must live as long as the root. Collective.
  MobilityRoot(const MobilityScene& scene, std::span<const Vec3> positions, double tolerance,
               Mobility& mobility, const Communicator& communicator);
  ~MobilityRoot();

  /// Returns B z at the positions; the mobility can be at others afterwards. The numbers z depend on the
  /// seed, the sphere or wavevector, and the component. The result is equal on all ranks. Collective.
  RootProduct at(std::span<const Vec3> positions, std::uint64_t seed);

 private:
  bool has_small_matrix() const;
  RootProduct of_matrix(std::span<const Vec3> positions, std::uint64_t seed) const;
  RootProduct of_split(std::span<const Vec3> positions, std::uint64_t seed);

  MobilityScene scene_;
  double tolerance_;
  Mobility& mobility_;
  const Communicator& communicator_;
  std::unique_ptr<GrandMobility> split_;  ///< null: no Ewald sum with positive parts
};

}  // namespace beadswim
