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

// Velocities of many spheres by forces on them, in Stokes flow: v_i = sum_j mu_ij f_j, with mu_ii = I/(6 pi
// eta a_i) and
//
//   Oseen         mu_ij of point forces (rotne_prager_tensor.hpp: oseen_tensor)
//   Rotne-Prager  mu_ij of spheres apart or overlapping, positive definite for any places
//   near          S^T mu S, mu Rotne and Prager's, S a local map of forces by which near spheres answer
//                 exactly along their lines (near_field.hpp); as definite, at hardly more cost
//
// in open space, or in a box with all images of all spheres: of periodic axes, and of axes with free-slip
// walls, which are mirrors. The images' sum leaves out k = 0: volume flux is zero. It is meant for forces
// that sum to zero. Few spheres in open space are summed pair by pair, exactly; all else by Ewald's sum,
// pairs for what is near and a mesh for the rest (ewald_split.hpp, particle_mesh.hpp), at a cost of N log N
// and memory of N.
//
// Page: docs/method/mobility-product.md.

namespace beadswim {

struct MobilityScene {
  MobilityModel model = MobilityModel::rpy;
  double viscosity = 0;       ///< dynamic, eta [mass/(length time)]
  std::optional<Box> box;     ///< none: open space
  std::vector<double> radii;  ///< of each sphere [length]
  double tolerance = 1e-4;    ///< error of velocities over their root mean square
};

class MobilityProduct {
 public:
  /// `positions`: where spheres are about, by which work is shared between pairs and mesh; the same product
  /// follows from any. Throws InputError if there is no sphere, or a radius, the viscosity, a length or the
  /// tolerance is not what it should be, or spheres are left over from swimmers of three. Collective.
  MobilityProduct(MobilityScene scene, std::span<const Vec3> positions, const Communicator& communicator);
  ~MobilityProduct();
  MobilityProduct(const MobilityProduct&) = delete;
  MobilityProduct& operator=(const MobilityProduct&) = delete;

  /// velocities[i] of sphere i. All arrays have all spheres, the same on all ranks. The same bits for the
  /// same numbers on the same number of ranks; on another number they agree to roundoff. Collective.
  void apply(std::span<const Vec3> positions, std::span<const Vec3> forces, std::span<Vec3> velocities) const;

  /// None where all pairs are summed.
  const std::optional<EwaldPlan>& plan() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace beadswim
