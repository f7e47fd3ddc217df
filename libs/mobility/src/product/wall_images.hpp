#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/particle_mesh.hpp"
#include "wall_reflection.hpp"

namespace beadswim {

/// Flow that a plane no-slip wall adds to the flow of force moments of many spheres (wall_reflection.hpp), at
/// all spheres, their own flow included. It is exact for spheres that do not overlap the wall.
class WallImages {
 public:
  struct Law {
    int order;  ///< highest moment, 0 to 2
    double viscosity;
    HalfSpace half_space;
    std::vector<double> radii;        ///< [length]; 0: point forces
    std::optional<EwaldPlan> plan{};  ///< nullopt, or without mirror points: all pairs are summed directly
  };

  explicit WallImages(Law law) : law_(std::move(law)) {}

  /// Returns true if add_flows() sums only the near part over pairs, and adds the far part of the flow
  /// without wall too.
  bool uses_mesh() const { return law_.plan && law_.plan->has_mirror_points; }

  /// Adds this rank's part of the flows at the spheres. `sources` and `flows`: force_moments.hpp. `mesh`: of
  /// the plan; not used if all pairs are summed directly. Collective.
  void add_flows(std::span<const Vec3> positions, std::span<const double> sources, std::span<double> flows,
                 ParticleMesh* mesh, const Communicator& communicator) const;
  /// Adds the flow of all spheres at a sphere at `place` in the fluid.
  void add_flow(std::span<const Vec3> positions, std::span<const double> sources, const Vec3& place,
                double radius, double* flow) const;

 private:
  /// Adds the flow of the spheres with these indices at a mirror point.
  void add_flow_at_mirror(std::span<const Vec3> positions, std::span<const double> sources,
                          std::span<const int> spheres, const Vec3& point, MirrorFlow& flow) const;

  Law law_;
};

}  // namespace beadswim
