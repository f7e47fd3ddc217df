#pragma once

#include <functional>
#include <string>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/coupling/scene.hpp"
#include "beadswim/io/json.hpp"

namespace beadswim {

/// Cost of lattice steps in one floating-point precision.
struct PrecisionCost {
  std::vector<double> cells;             ///< numbers of cells per rank, ascending
  std::vector<double> seconds_per_cell;  ///< core-seconds per cell and step for each entry of `cells` [s]
  std::vector<double> seconds_per_area;  ///< core-seconds per step and bead area, per BeadScheme [s/cell^2]

  BEADSWIM_FIELDS(cells, seconds_per_cell, seconds_per_area)
};

/// Cost of a lattice step on this machine with a number of ranks.
class LatticeSpeed {
 public:
  /// Constructs the cost from stored values. `precisions` contains one element for each value of Precision,
  /// in the order of this enumeration. Throws InputError if its lists do not have the lengths of the lists
  /// that measured() makes, or if a cost is negative or above one second.
  LatticeSpeed(int ranks, std::vector<PrecisionCost> precisions);

  /// Measures the cost of lattice steps. This takes some seconds. Collective.
  static LatticeSpeed measured(const Communicator& communicator);

  /// Returns the cost while the machine is as busy as at present: for each precision, this cost times the
  /// median ratio of short measurements of the fluid to the same costs of this object. Takes up to a second.
  /// Collective.
  LatticeSpeed at_present(const Communicator& communicator) const;

  /// Returns the core-seconds of one step of the scene. They are the sum of the cost of all cells, which
  /// depends on the number of cells per rank, and the cost of the surfaces of all beads.
  double step(const CoupledScene& scene) const;

  int ranks() const { return ranks_; }
  const std::vector<PrecisionCost>& precisions() const { return precisions_; }

 private:
  int ranks_ = 1;
  std::vector<PrecisionCost> precisions_;
};

/// Returns the time of lattice steps on this machine at present. If the same version of the program has
/// already measured it on the same processor with the same number of ranks, reads the time from the cache
/// file and corrects it by short measurements. Otherwise measures the time, which takes some seconds and
/// which `message` announces on rank 0, and writes the cache file: lattice-speed-RANKS.json in
/// $XDG_CACHE_HOME/beadswim or $HOME/.cache/beadswim. Collective.
LatticeSpeed speed_of_this_machine(const std::function<void(const std::string&)>& message,
                                   const Communicator& communicator);

Json lattice_speed_to_json(const LatticeSpeed& speed);

/// Converts JSON that lattice_speed_to_json() has made to a LatticeSpeed. Throws an exception derived from
/// std::exception if `json` has another form.
LatticeSpeed lattice_speed_from_json(const Json& json);

}  // namespace beadswim
