#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/mobility/particle_mesh.hpp"
#include "moment_sum.hpp"

namespace beadswim {

/// Velocities v of free spheres from the forces F on them. The higher moments H of the force on each sphere
/// make its surface move as a rigid body (force_moments.hpp). M is the matrix from moments to projections:
///
///   v = M_FF F + M_FH H,   M_HF F + M_HH H = 0
///
/// The method of conjugate gradients finds H, with the self-mobility of each sphere as preconditioner.
class MomentProduct {
 public:
  /// `plan`: parameters of the Ewald sum; nullopt: all pairs are summed directly. Collective.
  MomentProduct(const MobilityScene& scene, const std::optional<EwaldPlan>& plan,
                const Communicator& communicator);

  /// Arguments as of MobilityProduct::apply(). Collective.
  ProductWork solve(std::span<const Vec3> positions, std::span<const Vec3> forces,
                    std::span<Vec3> velocities) const;

  /// Sets `projections` to M `moments`, moment_count() numbers per sphere each. Collective.
  void apply(std::span<const Vec3> positions, std::span<const double> moments,
             std::span<double> projections) const;

 private:
  /// Returns the moments H that would cause `projections` on each sphere alone; F is zero.
  std::vector<double> precondition(std::span<const double> projections) const;

  MobilityScene scene_;
  const Communicator& communicator_;
  MomentSum pairs_;
  std::unique_ptr<ParticleMesh> mesh_;   ///< null: all pairs are summed without a mesh
  Eigen::MatrixXd self_, inverse_self_;  ///< self-mobility of a sphere of radius 1, and its inverse
};

}  // namespace beadswim
