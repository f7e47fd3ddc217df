#pragma once

#include <string>
#include <vector>

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/lattice_scales.hpp"
#include "beadswim/io/vti.hpp"

namespace beadswim {

/// Flow fields beside the trajectory: TRAJECTORY.flow/STEP.vti and TRAJECTORY.flow.pvd, in the layout's
/// units.
class FlowOutput {
 public:
  /// Throws InputError if the folder cannot be created. Fields of each `interval` steps up to step `done` are
  /// there from an earlier run that this one goes on with.
  FlowOutput(const std::string& trajectory, const LatticeScales& scales, long interval, long done,
             const Communicator& communicator);

  /// Velocity, pressure (over that of the resting fluid) and bead of every cell as they are now. Collective.
  void write(const CoupledSystem& system);

 private:
  PvdEntry entry_of(long step) const;
  void remove_after(long done) const;  ///< fields of later steps, which will be taken again

  std::string stem_;
  LatticeScales scales_;
  const Communicator& communicator_;
  std::vector<PvdEntry> entries_;
};

}  // namespace beadswim
