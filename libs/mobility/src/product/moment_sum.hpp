#pragma once

#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/force_moments.hpp"

namespace beadswim {

/// Flow of the force moments of many spheres at the other spheres (force_moments.hpp), summed over pairs: of
/// all pairs in open space, or the near part of an Ewald sum, with a correction for spheres that overlap.
class MomentSum {
 public:
  struct Law {
    int order;  ///< highest moment, 1 or 2
    double viscosity;
    std::vector<double> radii;  ///< radii of all spheres, images included [length]
    Vec3 lengths;               ///< edges of the periodic box; 0 in open space [length]
    double xi, cutoff;          ///< of the Ewald sum (ewald_plan.hpp); 0: all pairs in open space
  };

  explicit MomentSum(Law law) : law_(std::move(law)) {}

  /// Adds the part of the flow that this rank evaluates. `sources`: sources of all spheres; `flows`: flows at
  /// the first spheres (force_moments.hpp).
  void add_flows(std::span<const Vec3> positions, std::span<const double> sources, std::span<double> flows,
                 const Communicator& communicator) const;

  /// Subtracts from `flows` the flow of each sphere at itself that the far part of the Ewald sum contains.
  void subtract_far_flow(std::span<const double> sources, std::span<double> flows) const;

 private:
  struct Work;
  /// Returns the number of elements of the source or flow of a sphere.
  std::size_t elements() const { return 3 * derivative_count(law_.order); }
  void add_all_pairs(std::span<const Vec3> positions, std::span<const double> sources,
                     std::span<double> flows, const Communicator& communicator) const;
  void add_near_pairs(std::span<const Vec3> positions, std::span<const double> sources,
                      std::span<double> flows, const Communicator& communicator) const;
  void add_pair(Work& work, int one, int other, const Vec3& d) const;
  void add_overlap(Work& work, int one, int other, const Vec3& d) const;
  void flush(Work& work) const;

  Law law_;
};

}  // namespace beadswim
