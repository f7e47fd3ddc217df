#pragma once

#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/mobility/rotne_prager_tensor.hpp"
#include "mobility_kernels.hpp"

namespace beadswim {

/// Part of an Ewald sum that is evaluated pair by pair: the near part of spheres within the cutoff, and the
/// difference that overlaps make, which the mesh does not contain.
class NearPairs {
 public:
  struct Law {
    MobilityModel model;
    double viscosity;
    std::vector<double> radii;  ///< radii of all spheres, images included [length]
    Vec3 lengths;               ///< edges of the periodic box; 0 in open space [length]
    double xi, cutoff;
  };

  explicit NearPairs(Law law);

  /// Adds the contribution of this rank's pairs. `velocities` holds the first spheres, as many as are needed.
  void add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces,
                      std::span<Vec3> velocities, const Communicator& communicator) const;

 private:
  PairTensor tensor(double radius_i, double radius_j, double r) const;
  void tabulate();
  struct Work;
  void flush(Work& work, int one) const;

  Law law_;
  double min_tabulated_distance_;  ///< closer pairs are evaluated directly [length]
  bool has_one_radius_;            ///< radii are equal, or do not matter
  PairTable table_;
  std::vector<double> coefficients_;
};

/// Adds the contribution of this rank to the sum over all pairs in open space, without splitting.
void add_all_pairs(MobilityModel model, double viscosity, std::span<const double> radii,
                   std::span<const Vec3> positions, std::span<const Vec3> forces, std::span<Vec3> velocities,
                   const Communicator& communicator);

}  // namespace beadswim
