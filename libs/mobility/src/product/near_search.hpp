#pragma once

#include <span>
#include <vector>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "mobility_kernels.hpp"

namespace beadswim {

/// Spheres sorted by the cells of a cell list, and the search for close pairs among them.
class NearSearch {
 public:
  /// `receivers`: number of the first spheres, whose velocities are required; `lengths`: edges of the
  /// periodic box, 0 in open space [length].
  NearSearch(std::span<const Vec3> positions, std::size_t receivers, double cutoff, const Vec3& lengths)
      : cutoff_(cutoff), cells_(positions, cutoff, lengths) {
    for (const int sphere : order()) {
      for (int a = 0; a < 3; ++a) places_[a].push_back(positions[sphere][a]);
      is_receiver_.push_back(static_cast<std::size_t>(sphere) < receivers ? 1 : 0);
    }
    spheres_ = {.x = places_[0].data(),
                .y = places_[1].data(),
                .z = places_[2].data(),
                .is_receiver = is_receiver_.data(),
                .lengths = {lengths[0], lengths[1], lengths[2]}};
  }
  NearSearch(const NearSearch&) = delete;
  NearSearch& operator=(const NearSearch&) = delete;

  /// Returns the sphere at each place of the sorted list.
  const std::vector<int>& order() const { return cells_.order(); }

  /// Finds this rank's share of the pairs within the cutoff of which at least one sphere is a receiver. Calls
  /// sum(place) for each batch of pairs of the sphere at this place with others; sum must empty the batch.
  template <class Sum>
  void for_each_batch(PairBatch& batch, const Communicator& communicator, const Sum& sum) const {
    const auto [first, last] = rank_share(std::ssize(order()), communicator.rank(), communicator.size());
    for (int place = static_cast<int>(first); place < last; ++place) {
      cells_.for_each_range_after(place, [&](int begin, int end) {
        while ((begin = best_kernels<MobilityKernels>().find_near_spheres(spheres_, place, begin, end,
                                                                          cutoff_, batch)) < end)
          sum(place);
      });
      sum(place);
    }
  }

 private:
  double cutoff_;
  CellList cells_;
  std::vector<double> places_[3];
  std::vector<unsigned char> is_receiver_;
  SortedSpheres spheres_;
};

}  // namespace beadswim
