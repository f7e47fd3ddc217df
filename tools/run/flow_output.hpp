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
  /// Throws InputError if the folder cannot be created.
  FlowOutput(const std::string& trajectory, const LatticeScales& scales, const Communicator& communicator);

  /// Velocity, pressure (over that of the resting fluid) and bead of every cell as they are now. Collective.
  void write(const CoupledSystem& system);

 private:
  std::string stem_;
  LatticeScales scales_;
  const Communicator& communicator_;
  std::vector<PvdEntry> entries_;
};

}  // namespace beadswim
