#pragma once

#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/half_space.hpp"
#include "beadswim/core/vec3.hpp"
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
    std::vector<double> radii;  ///< [length]; 0: point forces
  };

  explicit WallImages(Law law) : law_(std::move(law)) {}

  /// Adds the flows at the spheres that this rank evaluates. `sources` and `flows`: force_moments.hpp.
  void add_flows(std::span<const Vec3> positions, std::span<const double> sources, std::span<double> flows,
                 const Communicator& communicator) const;
  /// Adds the flow of all spheres at a sphere at `place` in the fluid.
  void add_flow(std::span<const Vec3> positions, std::span<const double> sources, const Vec3& place,
                double radius, double* flow) const;

 private:
  MirrorFlow flow_at_mirror(std::span<const Vec3> positions, std::span<const double> sources,
                            const Vec3& point) const;

  Law law_;
};

}  // namespace beadswim
