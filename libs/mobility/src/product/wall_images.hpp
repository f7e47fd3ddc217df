#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/cell_list.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/ewald_plan.hpp"
#include "ewald_split.hpp"
#include "imaged_spheres.hpp"
#include "wall_reflection.hpp"

namespace beadswim {

/// Flow of the sources of many spheres at any place: of all spheres in open space, or of those within the
/// cutoff of an Ewald sum (its near part).
class SourceSum {
 public:
  /// `plan`: of the Ewald sum; nullopt: all spheres.
  SourceSum(const ImagedSpheres& spheres, Receivers receivers, const std::optional<EwaldPlan>& plan)
      : spheres_(spheres), receivers_(receivers) {
    if (plan) split_.emplace(plan->cutoff, plan->shape);
  }

  void set_positions(std::span<const Vec3> positions);
  /// Adds the flow of all spheres at a place apart from them, with the axes of a wall across `axis`.
  /// `sources`: force_moments.hpp.
  void add_flow(std::span<const double> sources, const Vec3& place, int axis, MirrorFlow& flow) const;

 private:
  ImagedSpheres spheres_;
  Receivers receivers_;
  std::optional<EwaldSplit> split_{};  ///< nullopt: all spheres are summed
  std::vector<Vec3> places_;         ///< [length]
  std::optional<CellList> cells_{};  ///< of the near part
};

/// Flow that a plane no-slip wall adds to the flow of force moments of many spheres (wall_reflection.hpp), at
/// all spheres, their own flow included. It is exact for spheres that do not overlap the wall.
class WallImages {
 public:
  /// `plan`: of a mesh; nullopt, or without mirror points: all pairs are summed directly.
  WallImages(const ImagedSpheres& spheres, const HalfSpace& half_space, const std::optional<EwaldPlan>& plan)
      : spheres_(spheres),
        half_space_(half_space),
        sum_(spheres, Receivers::spheres, plan && plan->has_mirror_points ? plan : std::nullopt) {}

  void set_positions(std::span<const Vec3> positions);

  /// Adds this rank's part of the flows at the spheres. `sources` and `flows`: force_moments.hpp. at_mirrors:
  /// this rank's part of the flow that a mesh with mirror points gives there, or 0; changed.
  void add_flows(std::span<const double> sources, std::span<MirrorFlow> at_mirrors, std::span<double> flows,
                 const Communicator& communicator) const;
  /// Adds the flow of all spheres at a sphere at `place` in the fluid.
  void add_flow(std::span<const double> sources, const Vec3& place, double radius, double* flow) const;

 private:
  ImagedSpheres spheres_;
  HalfSpace half_space_;
  SourceSum sum_;             ///< at the mirror points
  std::vector<Vec3> places_;  ///< [length]
};

}  // namespace beadswim
