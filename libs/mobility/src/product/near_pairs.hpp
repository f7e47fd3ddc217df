#pragma once

#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/mobility/rotne_prager_tensor.hpp"
#include "mobility_kernels.hpp"

namespace beadswim {

/// What an Ewald sum does pair by pair: the near part of spheres closer than the cut-off, and the whole of
/// what the mesh does not know, spheres that overlap.
class NearPairs {
 public:
  struct Law {
    MobilityModel model;
    double viscosity;
    std::vector<double> radii;  ///< of all sources
    Vec3 lengths;               ///< of the periodic box; 0: open space
    double xi, cut_off;
  };

  explicit NearPairs(Law law);

  /// Adds this rank's pairs to the velocities of the first spheres, as many as there are.
  void add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces,
                      std::span<Vec3> velocities, const Communicator& communicator) const;

 private:
  PairTensor tensor(double radius_i, double radius_j, double r) const;
  void tabulate();
  struct Work;
  void flush(Work& work, int one) const;

  Law law_;
  double touching_;  ///< pairs as close are not in the table
  bool is_alike_;    ///< one radius
  PairTable table_;
  std::vector<double> coefficients_;
};

/// All pairs, whole, in open space: adds this rank's.
void add_all_pairs(MobilityModel model, double viscosity, std::span<const double> radii,
                   std::span<const Vec3> positions, std::span<const Vec3> forces, std::span<Vec3> velocities,
                   const Communicator& communicator);

}  // namespace beadswim
