#pragma once

#include <memory>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/h5md.hpp"
#include "scene_on_lattice.hpp"

namespace beadswim {

/// Takes frames: writes them to the trajectory, and on rank 0 makes the statistics of each whole cycle of
/// them.
class Recorder {
 public:
  Recorder(const SceneOnLattice& on_lattice, int frames_per_cycle, TrajectoryWriter& trajectory);

  /// Step of frame k: as near to k/frames_per_cycle cycles as steps allow.
  long step_of_frame(long frame) const;

  /// Whether the next frame's step has come.
  bool is_due(long step) const { return step == step_of_frame(next_frame_); }

  /// Takes the next frame. `totals`: of the system as it is now. Collective.
  void record(const CoupledSystem& system, const SceneTotals& totals);

  const std::vector<SwimmerRecord>& swimmers() const { return swimmers_; }  ///< on rank 0

 private:
  void append_samples(const std::vector<SwimmerState>& swimmers, double time, const Vec3& mean_flow);
  void close_cycle();

  LatticeScales scales_;
  double period_;
  long steps_per_cycle_;
  int frames_per_cycle_;
  TrajectoryWriter& trajectory_;
  long next_frame_ = 0;
  std::vector<SwimmerRecord> swimmers_;
  std::vector<std::vector<SwimmerSample>> samples_;  ///< of the cycle so far, one list a swimmer
};

}  // namespace beadswim
