#pragma once

#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/mobility/rotne_prager_tensor.hpp"
#include "mobility_kernels.hpp"

namespace beadswim {

/// Part of an Ewald sum that is evaluated pair by pair. It contains the near part of all pairs within the
/// cutoff. For overlapping spheres it also contains the difference between the tensor of overlapping spheres
/// and the formula for spheres that do not overlap, which the mesh uses for all pairs.
class NearPairs {
 public:
  struct Law {
    MobilityModel model;
    double viscosity;
    std::vector<double> radii;  ///< radii of all spheres, images included [length]
    Vec3 lengths;               ///< edges of the periodic box; 0 in open space [length]
    double xi, cutoff;          ///< splitting parameter [1/length] and cutoff [length]
  };

  explicit NearPairs(Law law);

  /// Adds the velocities due to the pairs that this rank evaluates. `positions` and `forces` contain all
  /// spheres. `velocities` contains only the first spheres, whose velocities are required.
  void add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces,
                      std::span<Vec3> velocities, const Communicator& communicator) const;

 private:
  PairTensor tensor(double radius_i, double radius_j, double r) const;
  void tabulate();
  struct Work;
  void flush(Work& work, int one) const;

  Law law_;
  double min_tabulated_distance_;  ///< closer pairs are evaluated without the table [length]
  bool has_one_radius_;            ///< all radii are equal, or the model ignores radii
  PairTable table_;
  std::vector<double> coefficients_;
};

/// Adds the velocities due to this rank's share of all pairs in open space, without an Ewald sum.
void add_all_pairs(MobilityModel model, double viscosity, std::span<const double> radii,
                   std::span<const Vec3> positions, std::span<const Vec3> forces, std::span<Vec3> velocities,
                   const Communicator& communicator);

}  // namespace beadswim
