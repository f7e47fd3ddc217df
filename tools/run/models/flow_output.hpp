#pragma once

#include <string>
#include <vector>

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/lattice_scales.hpp"
#include "beadswim/io/vti.hpp"

namespace beadswim {

/// Writes flow fields, in units of the layout, to files TRAJECTORY.flow/STEP.vti. The file
/// TRAJECTORY.flow.pvd lists them for ParaView.
class FlowOutput {
 public:
  /// Creates the folder. `interval`: number of steps between flow fields. `done`: last step of the earlier
  /// run that this run continues, or 0. Fields of the earlier run up to this step stay in the list. Throws
  /// InputError if the folder cannot be created.
  FlowOutput(const std::string& trajectory, const LatticeScales& scales, long interval, long done,
             const Communicator& communicator);

  /// Writes for each cell the velocity, the pressure minus the pressure at rest, and the number of the bead
  /// that covers it (0: none). Collective.
  void write(const CoupledSystem& system);

 private:
  PvdEntry entry_of(long step) const;
  void remove_after(long done) const;  ///< removes fields of later steps, which this run writes anew

  std::string stem_;
  LatticeScales scales_;
  const Communicator& communicator_;
  std::vector<PvdEntry> entries_;
};

}  // namespace beadswim
