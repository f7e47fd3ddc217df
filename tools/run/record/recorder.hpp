#pragma once

#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/message.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/h5md.hpp"
#include "models/model.hpp"
#include "record/sampling_schedule.hpp"

namespace beadswim {

/// Records frames and samples. Frames are taken at the same phases of each base period and written to the
/// trajectory. Samples are taken at the same phases of each swimmer's own period; rank 0 computes cycle
/// statistics from them.
class Recorder {
 public:
  Recorder(const ModelPlan& plan, const Layout& layout, TrajectoryWriter& trajectory,
           const Communicator& communicator);

  /// Returns the step of frame k: the step nearest to k/frames_per_cycle cycles.
  long step_of_frame(long frame) const;

  /// Returns whether the next frame is due at this step.
  bool is_due(long step) const { return step == step_of_frame(next_frame_); }

  /// Samples the swimmers of this rank for which a sample is due. Call it before the first step and after
  /// every step.
  void sample(const Model& model);

  /// Records the next frame. `totals`: present totals of the model. Collective.
  void record(const Model& model, const ModelTotals& totals);

  // Statistics on rank 0. For more than max_swimmers_listed swimmers, only the last cycle is kept.
  std::vector<SwimmerRecord> swimmers() const;
  const std::vector<SwarmCycle>& swarm() const { return swarm_; }

  /// Returns the state for a checkpoint on rank 0, and an empty list on other ranks. Collective.
  std::vector<char> state();
  /// Restores the state of a run that had completed `steps_done` steps. `state` is used on rank 0 only.
  /// Throws SolverError if the state belongs to another run.
  void restore(std::vector<char> state, long steps_done);

 private:
  /// Bead positions of one swimmer at one sampling time, sent to rank 0.
  struct PositionSample {
    int id = 0;
    long number = 0;                ///< number k of the sample
    double time = 0;                ///< [step]
    std::array<Vec3, 3> positions;  ///< [ModelUnits]

    static void visit_fields(auto&& visit, auto& position_sample) {
      visit("id", position_sample.id);
      visit("number", position_sample.number);
      visit("time", position_sample.time);
      visit("positions", position_sample.positions);
    }
  };
  /// Data of one swimmer on rank 0.
  struct SwimmerLog {
    SwimmerRecord record;
    std::array<Bead, 3> beads;  ///< beads in units of the layout
    double period = 0;          ///< driving period [time]
    int samples_per_cycle = 1;
    std::vector<SwimmerSample> samples;  ///< samples of the current cycle
  };
  /// Mean flow at the time of a frame, in units of the layout.
  struct FlowSample {
    double time = 0;
    Vec3 mean_flow = Vec3::Zero();
  };

  /// Returns whether frames and samples can be those of a run that had completed `steps_done` steps.
  bool is_consistent_with(long steps_done) const;
  void gather_samples();
  void store_samples(const FlowSample& now);
  void store_sample(SwimmerLog& log, const PositionSample& position_sample, const FlowSample& now);
  void append_cycles(long step, double time);
  void append_swarm(const std::vector<SwimmerPose>& swimmers, const Vec3& momentum);
  template <class Message>
  void transfer(Message& message);

  bool is_cycle_end() const { return next_frame_ > 0 && next_frame_ % frames_per_cycle_ == 0; }

  ModelUnits units_;
  double time_step_;
  const Communicator& communicator_;
  long steps_per_cycle_;
  int frames_per_cycle_;
  std::optional<Box> box_;
  TrajectoryWriter& trajectory_;
  SamplingSchedules schedules_;
  long next_frame_ = 0;
  OutgoingMessage pending_samples_;  ///< samples of this rank that have not been gathered

  // Used on rank 0 only:
  std::vector<PositionSample> gathered_;  ///< samples since the last frame
  FlowSample last_frame_;
  std::vector<SwimmerLog> logs_;   ///< in the order of swimmer ids
  std::vector<SwarmCycle> swarm_;  ///< for two or more swimmers
};

}  // namespace beadswim
