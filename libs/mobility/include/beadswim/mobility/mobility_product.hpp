#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/ewald_plan.hpp"
#include "beadswim/mobility/mobility_model.hpp"

// Velocities of many spheres from the forces on them in Stokes flow:
//
//   v_i = sum_j mu_ij f_j,   mu_ii = I/(6 pi eta a_i)
//
//   oseen     mu_ij of point forces (rotne_prager_tensor.hpp: oseen_tensor)
//   rpy       Rotne-Prager-Yamakawa tensor of spheres; positive definite for any positions, overlaps included
//   rpy+near  S^T mu S with mu as in rpy; S is a local map of the forces that makes the mobility of close
//   spheres
//             exact along their lines (near_field.hpp); also positive definite, at little additional cost
//
// The spheres are in open space, or in a box with all images of all spheres. Each axis of the box is periodic
// or has free-slip walls, which act as mirrors. The sum over images leaves out k = 0, so the volume flux is
// zero. The sum is intended for forces that sum to zero.
//
// Few spheres in open space are summed pair by pair, without approximation. Otherwise an Ewald sum is used:
// the near part is a sum over pairs, the far part is evaluated on a mesh (ewald_split.hpp,
// particle_mesh.hpp). Its cost is N log N, its memory N.
//
// Page: docs/method/mobility-product.md.

namespace beadswim {

struct MobilityScene {
  MobilityModel model = MobilityModel::rpy;
  double viscosity = 0;       ///< dynamic, eta [mass/(length time)]
  std::optional<Box> box;     ///< none: open space
  std::vector<double> radii;  ///< one per sphere [length]
  double tolerance = 1e-4;    ///< error of velocities, relative to their root mean square
};

class MobilityProduct {
 public:
  /// `positions` [length] are approximate positions of the spheres. They determine the division of the work
  /// between pairs and mesh, and change results only within the tolerance. Throws InputError if there is no
  /// sphere; if a radius, the viscosity, a length or the tolerance is invalid; or if the model is rpy_near
  /// and the number of spheres is not a multiple of three. Collective.
  MobilityProduct(MobilityScene scene, std::span<const Vec3> positions, const Communicator& communicator);
  ~MobilityProduct();
  MobilityProduct(const MobilityProduct&) = delete;
  MobilityProduct& operator=(const MobilityProduct&) = delete;

  /// Sets velocities[i] of each sphere i. All arrays hold all spheres and are equal on all ranks. On the same
  /// number of ranks equal arguments give the same bits; on different numbers of ranks results agree to
  /// roundoff. Collective.
  void apply(std::span<const Vec3> positions, std::span<const Vec3> forces, std::span<Vec3> velocities) const;

  /// Returns the parameters of the Ewald sum, or nothing if all pairs are summed.
  const std::optional<EwaldPlan>& plan() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace beadswim
