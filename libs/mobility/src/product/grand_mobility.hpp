#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "pair_sum.hpp"
#include "particle_mesh.hpp"
#include "unresolved_memory.hpp"
#include "wall_images.hpp"

namespace beadswim {

/// Returns the parameters of an Ewald sum with positive parts, for the root of the mobility in a box; nullopt
/// if the box is too narrow. Collective.
std::optional<EwaldPlan> root_plan(const MobilityScene& scene, std::span<const Vec3> positions,
                                   const Communicator& communicator);

/// Matrix M from the moments of the forces on all spheres to the projections of their flow on the moments of
/// all spheres (force_moments.hpp), and the memory of the fluid. It is the sum of parts, each made once:
///
///   pairs   all pairs in open space, or the near part of an Ewald sum
///   mesh    far part of the Ewald sum; with memory of the fluid, its Fourier modes
///   wall    flow that the wall of a half-space adds
///   self    each sphere alone; with memory, the flow that the mesh does not resolve
class GrandMobility {
 public:
  /// `plan`: parameters of the Ewald sum; nullopt: all pairs are summed directly. Collective.
  GrandMobility(const MobilityScene& scene, const std::optional<EwaldPlan>& plan,
                const Communicator& communicator);

  int moments_per_sphere() const { return moment_count(order()); }
  /// Sets the positions for later products [length]. Collective.
  void set_positions(std::span<const Vec3> positions);

  /// Sets `projections` to M `moments`, moment_count() numbers per sphere each, with the projections of the
  /// flow that earlier forces have left if `part` asks for them. Collective.
  void apply(std::span<const double> moments, std::span<double> projections, FlowPart part);
  /// Sets `velocities`, three numbers per sphere, to random ones whose covariance is the far part of the
  /// Ewald sum. The random numbers depend on the seed and the wavevector. Only without moments and memory, in
  /// boxes. Collective.
  void set_far_noise(std::uint64_t seed, std::span<double> velocities);
  /// Adds the flow of the moments of spheres at `positions` at points without size, except at those that lie
  /// in a sphere (spheres[p] >= 0), and the flow by the memory of the fluid. `plan`: of the Ewald sum for the
  /// points; nullopt: all pairs are summed directly. Collective.
  void add_flow_at(std::span<const Vec3> points, std::span<const Vec3> positions,
                   std::span<const double> moments, const std::optional<EwaldPlan>& plan,
                   std::span<const int> spheres, std::span<Vec3> velocities);
  /// Returns the moments H that would cause `projections` on each sphere alone; the forces are zero.
  std::vector<double> precondition(std::span<const double> projections) const;

  bool has_memory() const { return unresolved_.has_value(); }
  /// Sets the fluid at rest. The moments begin to act. Collective.
  void start(std::span<const double> moments);
  /// Ends a time step, at whose end the moments act. Collective.
  void end_step(std::span<const double> moments, const Vec3& mean_flow);
  MemoryField& modes() { return *mesh_->memory(); }
  UnresolvedMemory& unresolved() { return *unresolved_; }

 private:
  struct SelfMobility {
    Eigen::MatrixXd beside_mesh;  ///< without the far part of the Ewald sum, which the mesh contains
    Eigen::MatrixXd inverse;      ///< inverse of the whole self-mobility of the higher moments
  };
  SelfMobility self_mobility_of(std::size_t sphere, const std::optional<EwaldSplit>& split) const;
  int order() const { return spheres_.order; }
  std::vector<double> sources_of(std::span<const double> moments) const;

  Domain domain_;
  std::vector<double> radii_;  ///< of the spheres without images [length]
  ImagedSpheres spheres_;
  const Communicator& communicator_;
  bool is_for_noise_;
  PairSum pairs_;
  std::unique_ptr<ParticleMesh> mesh_{};          ///< null: all pairs are summed without a mesh
  std::optional<WallImages> wall_{};              ///< nullopt: without half-space
  std::optional<UnresolvedMemory> unresolved_{};  ///< nullopt: steady flow
  std::vector<std::shared_ptr<const SelfMobility>> self_;  ///< of each sphere; equal spheres share one
};

}  // namespace beadswim
