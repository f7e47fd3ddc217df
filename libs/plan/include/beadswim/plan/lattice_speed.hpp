#pragma once

#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/scene.hpp"

namespace beadswim {

/// Cost of lattice steps in one precision.
struct PrecisionCost {
  std::vector<double> cells;             ///< cells per rank, ascending
  std::vector<double> seconds_per_cell;  ///< core-seconds per cell and step with so many cells per rank [s]
  std::vector<double> seconds_per_area;  ///< core-seconds per step and cell^2 of bead surface, by scheme [s]

  static void visit_fields(auto&& visit, auto& cost) {
    visit("cells", cost.cells);
    visit("seconds_per_cell", cost.seconds_per_cell);
    visit("seconds_per_area", cost.seconds_per_area);
  }
};

/// Cost of a lattice step on this machine with a number of ranks.
class LatticeSpeed {
 public:
  /// `precisions` is in the order of Precision. Throws InputError if its lists have other lengths than
  /// measured() gives, or hold values that no machine has.
  LatticeSpeed(int ranks, std::vector<PrecisionCost> precisions);

  /// Measures the cost of steps, which takes some seconds. Collective.
  static LatticeSpeed measured(const Communicator& communicator);

  /// Returns the core-seconds of a step: those of its cells, by their number per rank, and those of the
  /// surface of its beads.
  double step(const CoupledScene& scene) const;

  int ranks() const { return ranks_; }
  const std::vector<PrecisionCost>& precisions() const { return precisions_; }

 private:
  int ranks_ = 1;
  std::vector<PrecisionCost> precisions_;
};

}  // namespace beadswim
