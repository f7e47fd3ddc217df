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
#include "unresolved_memory.hpp"
#include "wall_images.hpp"

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
  ProductWork solve(std::span<const Vec3> positions, std::span<const Vec3> forces, std::span<Vec3> velocities,
                    FlowPart part = FlowPart::forces);

  /// Sets `projections` to M `moments`, moment_count() numbers per sphere each, with the projections of the
  /// background flow and of that which earlier forces have left if `part` asks for them. Collective.
  void apply(std::span<const Vec3> positions, std::span<const double> moments, std::span<double> projections,
             FlowPart part = FlowPart::forces) const;

  /// Solves for the moments at the end of a time step and transforms their sources, which
  /// MemoryField::start() or end_step() then uses. Collective.
  ProductWork solve_end_of_step(std::span<const Vec3> positions, std::span<const Vec3> forces);

  /// Returns the moments at the end of the last two steps, the last step first. The solution for the next
  /// step begins with moments extrapolated from them. They are equal on all ranks.
  const std::vector<double>& history() const { return moment_history_; }
  void restore(std::vector<double> history) { moment_history_ = std::move(history); }

  /// Returns the memory of the fluid on the mesh; null for steady flow.
  MemoryField* memory() const { return mesh_ ? mesh_->memory() : nullptr; }
  std::optional<UnresolvedMemory>& unresolved() { return unresolved_; }

 private:
  double power(std::span<const Vec3> positions, std::span<const Vec3> forces,
               std::span<const Vec3> velocities, FlowPart part) const;
  /// Returns true if the product contains a background flow.
  bool has_background(FlowPart part) const { return part == FlowPart::all && !scene_.flow.is_zero(); }
  /// Returns the projections of the background flow.
  std::vector<double> projected_background(std::span<const Vec3> positions) const;
  /// Returns the moments at the end of a step, extrapolated from earlier steps.
  std::vector<double> extrapolated_moments(std::size_t spheres) const;
  /// As solve(), beginning with the higher moments in `moments`, and returns all moments there.
  ProductWork solve_from(std::span<const Vec3> positions, std::span<const Vec3> forces,
                         std::span<Vec3> velocities, FlowPart part, std::vector<double>& moments) const;
  /// Positions and sources of all spheres and their mirror images.
  struct Sources {
    std::vector<Vec3> places;
    std::vector<double> sources;
  };
  Sources sources_of(std::span<const Vec3> positions, std::span<const double> moments) const;
  /// Returns the moments H that would cause `projections` on each sphere alone; F is zero.
  std::vector<double> precondition(std::span<const double> projections) const;

  MobilityScene scene_;
  const Communicator& communicator_;
  MomentSum pairs_;
  std::unique_ptr<ParticleMesh> mesh_;          ///< null: all pairs are summed without a mesh
  std::optional<WallImages> wall_;              ///< nullopt: without half-space
  std::optional<UnresolvedMemory> unresolved_;  ///< nullopt: steady flow
  double background_power_ = 0;          ///< power of the background flow's strain on all spheres, each alone
  Eigen::MatrixXd self_, inverse_self_;  ///< self-mobility of a sphere of radius 1, and its inverse
  std::vector<double> moment_history_;   ///< moments at the end of the last step, and of the step before
  std::vector<double> moments_in_step_;  ///< moments that the last solution with memory has found
};

}  // namespace beadswim
