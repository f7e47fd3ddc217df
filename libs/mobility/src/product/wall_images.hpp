#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/cell_list.hpp"
#include "beadswim/core/communicator.hpp"
#include "particle_mesh.hpp"
#include "wall_reflection.hpp"

namespace beadswim {

/// Flow that a plane no-slip wall adds to the flow of force moments of many spheres (wall_reflection.hpp), at
/// all spheres, their own flow included. It is exact for spheres that do not overlap the wall.
class WallImages {
 public:
  /// `plan`: of the mesh; nullopt, or without mirror points: all pairs are summed directly.
  WallImages(const ImagedSpheres& spheres, const HalfSpace& half_space, const std::optional<EwaldPlan>& plan)
      : spheres_(spheres), half_space_(half_space), plan_(plan) {}

  /// Returns true if add_flows() sums only the near part over pairs, and adds the far part of the flow
  /// without wall too.
  bool uses_mesh() const { return plan_ && plan_->has_mirror_points; }

  void set_positions(std::span<const Vec3> positions);

  /// Adds this rank's part of the flows at the spheres. `sources` and `flows`: force_moments.hpp. `mesh`: of
  /// the plan, at the same positions; not used if all pairs are summed directly. Collective.
  void add_flows(std::span<const double> sources, std::span<double> flows, ParticleMesh* mesh,
                 const Communicator& communicator) const;
  /// Adds the flow of all spheres at a sphere at `place` in the fluid.
  void add_flow(std::span<const double> sources, const Vec3& place, double radius, double* flow) const;

 private:
  /// Adds the flow of the spheres with these indices at a mirror point.
  void add_flow_at_mirror(std::span<const double> sources, std::span<const int> spheres, const Vec3& point,
                          MirrorFlow& flow) const;

  ImagedSpheres spheres_;
  HalfSpace half_space_;
  std::optional<EwaldPlan> plan_;
  std::vector<Vec3> places_;         ///< [length]
  std::vector<int> all_;             ///< indices of all spheres
  std::optional<CellList> cells_{};  ///< nullopt: all pairs are summed directly
};

}  // namespace beadswim
