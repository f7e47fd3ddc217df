#pragma once

#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/message.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/h5md.hpp"
#include "models/model.hpp"
#include "record/sampling_schedule.hpp"

namespace beadswim {

/// Takes frames and samples. Frames, each base period alike, go to the trajectory; samples, each swimmer's
/// own period alike, become the statistics of its cycles, on rank 0.
class Recorder {
 public:
  Recorder(const ModelPlan& plan, const Layout& layout, TrajectoryWriter& trajectory,
           const Communicator& communicator);

  /// Step of frame k: as near to k/frames_per_cycle cycles as steps allow.
  long step_of_frame(long frame) const;

  /// Whether the next frame's step has come.
  bool is_due(long step) const { return step == step_of_frame(next_frame_); }

  /// Samples those of this rank's swimmers whose time has come. To be called after every step, and before the
  /// first.
  void sample(const Model& model);

  /// Takes the next frame. `totals`: of the model as it is now. Collective.
  void record(const Model& model, const ModelTotals& totals);

  // On rank 0. Of many swimmers only the last cycle is kept.
  std::vector<SwimmerRecord> swimmers() const;
  const std::vector<SwarmCycle>& swarm() const { return swarm_; }

  /// What a checkpoint keeps; on rank 0, empty elsewhere. Collective.
  std::vector<char> state();
  /// `state`: on rank 0, of a run that had done `steps_done`. Throws SolverError if it is of another run.
  void restore(std::vector<char> state, long steps_done);

 private:
  /// A sample on its way to rank 0.
  struct Note {
    int id = 0;
    long number = 0;                ///< k
    double time = 0;                ///< [step]
    std::array<Vec3, 3> positions;  ///< [ModelUnits]

    static void visit_fields(auto&& visit, auto& note) {
      visit("id", note.id);
      visit("number", note.number);
      visit("time", note.time);
      visit("positions", note.positions);
    }
  };
  /// What rank 0 knows of one swimmer.
  struct Log {
    SwimmerRecord record;
    std::array<Bead, 3> beads;  ///< the layout's
    double period = 0;          ///< [time]
    int samples_per_cycle = 1;
    std::vector<SwimmerSample> samples;  ///< of the cycle so far
  };
  /// The whole of one frame's time that concerns all.
  struct Moment {
    double time = 0;
    Vec3 mean_flow = Vec3::Zero();
  };

  /// Whether frames and notes are those of a run that had done so many steps.
  bool fits(long steps_done) const;
  void gather_notes();
  void take_notes(const Moment& now);
  void take_note(Log& log, const Note& note, const Moment& now);
  void append_cycles(long step, double time);
  void append_swarm(const std::vector<SwimmerSight>& swimmers, const Vec3& momentum);
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
  OutgoingMessage notes_;  ///< of this rank's swimmers, since they were gathered

  // On rank 0.
  std::vector<Note> gathered_;  ///< since the last frame
  Moment last_frame_;
  std::vector<Log> logs_;          ///< swimmers in order of their ids
  std::vector<SwarmCycle> swarm_;  ///< of two swimmers or more
};

}  // namespace beadswim
