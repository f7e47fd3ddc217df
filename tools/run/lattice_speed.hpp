#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {

/// How fast this machine steps a lattice, on so many ranks: what a step costs in core-seconds.
class LatticeSpeed {
 public:
  /// From the cache of an earlier call by the same version on the same processor and number of ranks
  /// (speed_cache()), else measured, which takes some seconds and is said on standard error. Collective.
  static LatticeSpeed of_this_machine(const Communicator& communicator);

  /// Core-seconds of a step: of its cells, by how many each rank has, and of the surface of its beads.
  double step(const CoupledScene& scene) const;

  Json to_json() const;
  /// Throws an exception if it is not what to_json gives.
  static LatticeSpeed from_json(const Json& json);

 private:
  struct OfPrecision {
    std::vector<double> cells;             ///< that a rank has, ascending
    std::vector<double> seconds_per_cell;  ///< core-seconds with so many
    std::vector<double> seconds_per_area;  ///< core-seconds a cell^2 of bead surface, by scheme
  };

  static LatticeSpeed measured(const Communicator& communicator);
  static std::optional<LatticeSpeed> cached(int ranks);

  int ranks_ = 1;
  std::vector<OfPrecision> precisions_;  ///< in the order of Precision
};

/// The file that keeps it: in $XDG_CACHE_HOME/beadswim, else ~/.cache/beadswim; empty where there is neither.
std::string speed_cache(int ranks);

}  // namespace beadswim
