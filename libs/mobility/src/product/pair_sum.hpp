#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/cell_list.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/ewald_plan.hpp"
#include "ewald_split.hpp"
#include "imaged_spheres.hpp"
#include "tensor_table.hpp"

namespace beadswim {

/// Flow of the sources of many spheres at the other spheres (force_moments.hpp), summed over pairs: over all
/// pairs in open space, or the near part of an Ewald sum, with a correction for spheres that overlap.
class PairSum {
 public:
  /// `plan`: of the Ewald sum; nullopt: sum over all pairs in open space. `min_distance`: of TensorTable.
  PairSum(const ImagedSpheres& spheres, const std::optional<EwaldPlan>& plan, double min_distance);

  /// Sets the positions of all spheres and images. `receivers`: number of the spheres without images.
  void set_positions(std::span<const Vec3> positions, std::size_t receivers);

  /// Adds the part of the flow that this rank evaluates. `sources`: of all spheres and images; `flows`: at
  /// the receivers.
  void add_flows(std::span<const double> sources, std::span<double> flows, const Communicator& communicator);

 private:
  struct Work;
  void add_all_pairs(Work& work, const Communicator& communicator) const;
  void add_near_pairs(Work& work, const Communicator& communicator);
  SortedSpheres sorted_spheres() const;
  void add_near(Work& work, const SortedSpheres& spheres, int one, std::span<const int> others,
                std::span<const int> closest) const;
  void add_pair(Work& work, int one, int other, const Vec3& d, double r) const;
  void add_forces(Work& work, int one, int other, const Vec3& d, double r) const;
  void add_overlap(Work& work, int one, int other, const Vec3& d) const;
  void set_radials(Work& work) const;
  void flush(Work& work) const;

  ImagedSpheres spheres_;
  std::optional<EwaldSplit> split_{};   ///< nullopt: all pairs in open space
  bool is_positive_;                    ///< EwaldPlan::is_positive
  std::optional<TensorTable> table_{};  ///< of forces without moments; nullopt: moments, or all pairs
  std::optional<CellList> cells_{};     ///< nullopt: all pairs
  /// Pairs of the sphere `one`: elements of neighbour_list_ from `first` on, the closest ones last.
  struct NeighbourRange {
    int one;
    std::size_t others, closest, first;
  };
  int sums_ = 0;  ///< number of sums at these positions
  std::vector<int> neighbour_list_;
  std::vector<NeighbourRange> neighbour_ranges_;
  // Of the spheres and images in the order of the sum, by cells.
  std::vector<int> order_;  ///< index of each sphere
  std::array<std::vector<double>, 3> coordinates_;
  std::vector<unsigned char> is_receiver_;
  std::vector<double> radii_, squares_;  ///< a, a^2
};

}  // namespace beadswim
