#pragma once

#include <string>
#include <vector>

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/lattice_scales.hpp"
#include "beadswim/io/vti.hpp"

namespace beadswim {

/// Writes flow fields to TRAJECTORY.flow/STEP.vti, with the index TRAJECTORY.flow.pvd, in units of the
/// layout.
class FlowOutput {
 public:
  /// Creates the folder. `interval`: steps between fields. `done`: last step of the earlier run that this run
  /// continues, or 0; its fields up to this step are kept in the index. Throws InputError if the folder
  /// cannot be created.
  FlowOutput(const std::string& trajectory, const LatticeScales& scales, long interval, long done,
             const Communicator& communicator);

  /// Writes velocity, pressure relative to the fluid at rest, and bead number of each cell. Collective.
  void write(const CoupledSystem& system);

 private:
  PvdEntry entry_of(long step) const;
  void remove_after(long done) const;  ///< removes fields of later steps, which will be written again

  std::string stem_;
  LatticeScales scales_;
  const Communicator& communicator_;
  std::vector<PvdEntry> entries_;
};

}  // namespace beadswim
