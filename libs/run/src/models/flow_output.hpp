#pragma once

#include <string>
#include <vector>

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/io/vti.hpp"
#include "beadswim/scene/unit_scales.hpp"

namespace beadswim {

/// Writes flow fields, in units of the layout, to files TRAJECTORY.flow/STEP.vti, and lists these files for
/// ParaView in TRAJECTORY.flow.pvd. TRAJECTORY is the path of the trajectory file. With several levels of
/// cells, each has its own file STEP-N.vti, where N counts from the coarsest level, 0; cells under a finer
/// level are hidden.
class FlowOutput {
 public:
  /// Creates the folder for the files. `path`: trajectory; `done`: last step of the earlier run that this run
  /// continues, or 0: flow fields of later steps are removed; `levels`: number of levels of cells. Throws
  /// InputError if the folder cannot be created.
  FlowOutput(const std::string& path, const UnitScales& scales, long done, int levels,
             const Communicator& communicator);

  const std::vector<long>& steps() const { return steps_; }  ///< steps whose flow fields are listed
  /// Lists the flow fields that the earlier run has written at these steps, before those of this run.
  void restore(const std::vector<long>& steps);

  /// Writes velocity, pressure and bead for each cell: the pressure is relative to the fluid at rest, and the
  /// bead is the number of the bead that covers the cell (0: none). Collective.
  void write(const CoupledSystem& system);

 private:
  /// Returns the files of a step.
  std::vector<PvdEntry> entries_of(long step) const;
  void write_index() const;  ///< lists the files, on rank 0
  void write_level(const CoupledSystem& system, int number, const std::string& file);
  void remove_after(long done) const;  ///< removes flow fields of later steps, which this run rewrites

  std::string stem_;
  UnitScales scales_;
  long done_;
  int levels_;
  const Communicator& communicator_;
  std::vector<long> steps_;
};

}  // namespace beadswim
