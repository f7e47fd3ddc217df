#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/compare/diffusion.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/core/message.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/h5md.hpp"
#include "beadswim/run/model.hpp"
#include "beadswim/theory/methods.hpp"

namespace beadswim {

/// Sampling times of the swimmers of one type: sample k is taken at the time step nearest to k/per_cycle()
/// driving periods.
class SamplingSchedule {
 public:
  /// `period`: driving period [step]. The schedule has at most `max_per_cycle` samples per period, and at
  /// most one sample per time step. A period that is an integer but for rounding errors is rounded, so that
  /// samples of swimmers with the base period are taken exactly at frames.
  SamplingSchedule(double period, int max_per_cycle) {
    const double whole = std::round(period);
    const double steps = std::abs(period - whole) < 1e-9 * period ? whole : period;
    per_cycle_ = static_cast<int>(std::min<double>(max_per_cycle, std::floor(steps)));
    interval_ = steps / per_cycle_;
  }

  int per_cycle() const { return per_cycle_; }
  long next_step() const { return next_step_; }  ///< step of the next sample
  /// Returns the number of the sample nearest to a step.
  long number_at(long step) const { return std::lround(static_cast<double>(step) / interval_); }
  /// Returns the exact time of a sample [step].
  double time_of(long number) const { return static_cast<double>(number) * interval_; }

  /// Skips samples that are due before `step`, which must not be smaller than in the last call.
  void advance_to(long step) {
    if (next_step_ >= step) return;
    const long number = number_at(step), nearest = std::lround(time_of(number));
    next_step_ = nearest >= step ? nearest : std::lround(time_of(number + 1));
  }

 private:
  int per_cycle_ = 1;
  double interval_ = 1;  ///< [step]
  long next_step_ = 0;
};

/// Returns cycle statistics with as many arms as any type of the layout has, at least one. A trajectory has
/// so many columns; swimmers with fewer arms have NaN in the others.
CycleStatistics widest_cycle(const Layout& layout);

/// Records frames and samples of a run. A frame contains the positions and velocities of all beads and is
/// written to the trajectory. A sample contains the bead positions of one swimmer; rank 0 computes the
/// statistics of each cycle from the samples. Frames are taken at equal phases of each base period. Samples
/// are taken at equal phases of each driving period of the swimmer.
class Recorder {
 public:
  /// Plan, layout and communicator must exist as long as the recorder. `trajectory`: nullptr: frames are not
  /// written.
  Recorder(const ModelPlan& plan, const Layout& layout, TrajectoryWriter* trajectory,
           const Communicator& communicator);

  /// Returns the exact time of a frame, which is frame / frames_per_cycle base cycles [step].
  double time_of_frame(long frame) const;
  /// Returns the time step nearest to the time of a frame. The frame is taken at the end of this step.
  long step_of_frame(long frame) const;

  /// Returns true if the next frame must be taken at this step.
  bool is_due(long step) const { return step == step_of_frame(next_frame_); }

  /// Takes the samples that are due at the present step, for the swimmers of this rank. Must be called before
  /// the first step and after every step.
  void sample(const Model& model);

  /// Takes the next frame and writes it to the trajectory. Positions and velocities are extrapolated to the
  /// exact time of the frame, over at most half a time step. `totals`: present totals of the model.
  /// Collective.
  void record(const Model& model, const ModelTotals& totals);

  // Return statistics, on rank 0 only. For more than max_swimmers_listed swimmers, the result of swimmers()
  // contains only the last cycle of each swimmer.
  std::vector<SwimmerRecord> swimmers() const;
  const std::vector<SwarmCycle>& swarm() const { return swarm_; }
  /// Returns the diffusion of the swimmers in a run with thermal noise. On rank 0 only.
  DiffusionStatistics diffusion() const { return diffusion_statistics(paths_, plan_.base_period); }
  /// Returns a warning if samples are too far apart for the rotation of a swimmer.
  std::vector<RunWarning> warnings() const;

  /// Returns the state of the recorder for a checkpoint, on rank 0; returns an empty list on other ranks.
  /// Collective.
  std::vector<char> state();
  /// Restores the recorder of a run that had completed `steps_done` time steps. `state` is used on rank 0
  /// only. Throws DataError if the state belongs to another run.
  void restore(std::vector<char> state, long steps_done);

 private:
  /// Bead positions and force dipole of one swimmer at one sampling time, sent to rank 0.
  struct PositionSample {
    int id = 0;
    long number = 0;              ///< number of the sample since the start of the run
    double time = 0;              ///< [step]
    DipoleSample dipole;          ///< [ModelPlan::units]
    std::vector<Vec3> positions;  ///< [ModelPlan::units]

    BEADSWIM_FIELDS(id, number, time, dipole, positions)
  };
  /// Data that rank 0 stores for one swimmer.
  struct SwimmerLog {
    SwimmerRecord record;
    SwimmerType type;  ///< in units of the layout, with the swimmer's own driving
    Eigen::Matrix3d initial_orientation = Eigen::Matrix3d::Identity();
    int samples_per_cycle = 1;
    std::vector<SwimmerSample> samples;  ///< samples of the current cycle
  };
  /// Mean flow at the time of a frame, in units of the layout.
  struct FlowSample {
    double time = 0;
    Vec3 mean_flow = Vec3::Zero();
  };

  /// Returns true if the restored frames and samples are possible after `steps_done` time steps.
  bool is_consistent_with(long steps_done) const;
  void advance_schedules(long step);  ///< skips samples that are due before `step`
  void gather_samples();
  void store_samples(const FlowSample& now);
  void store_sample(SwimmerLog& log, const PositionSample& position_sample, const FlowSample& now);
  /// Returns the statistics of the cycle whose samples `log` contains. In swarms of more than
  /// max_swimmers_listed swimmers, the efficiency is left out.
  CycleStatistics statistics_of(const SwimmerLog& log, int index) const;
  /// Returns the drag coefficient of the swimmer with its mean shape in this cycle, towed along its axis in
  /// open space [mass/time]; nothing if beads nearly touch.
  std::optional<double> drag_in_cycle(const SwimmerLog& log, const CycleStatistics& cycle) const;
  /// Adds the forces of fluid and drives to a frame. Those of the fluid are means since the last frame where
  /// the model gives integrals.
  void add_forces(const Model& model, TrajectoryFrame& frame);
  /// Updates largest_turn_ with the present motion.
  void record_turns(const std::vector<SwimmerMotion>& swimmers);
  void extend_paths(const std::vector<SwimmerMotion>& swimmers);
  void append_cycles(long step, double time);
  void append_swarm(const std::vector<SwimmerMotion>& swimmers, const Vec3& momentum);
  template <class Message>
  void transfer(Message& message);

  bool is_cycle_end() const { return next_frame_ > 0 && next_frame_ % frames_per_cycle_ == 0; }

  const ModelPlan& plan_;
  const Layout& layout_;
  const Communicator& communicator_;
  int frames_per_cycle_;
  double dynamic_viscosity_;     ///< [mass/(length time)]
  const Method& towing_method_;  ///< method of theory for the drag of a towed three-bead swimmer
  PairTensorLaw pairs_;          ///< mobility for the drag of another towed swimmer
  TrajectoryWriter* trajectory_;
  std::vector<SamplingSchedule> schedules_;  ///< of each type
  long next_sample_ = 0;                     ///< step of the next sample of any type
  long next_frame_ = 0;
  OutgoingMessage pending_samples_;  ///< samples of this rank that were not yet sent to rank 0

  // Used on rank 0 only:
  std::vector<PositionSample> gathered_;  ///< samples of all ranks since the last frame
  FlowSample last_frame_;
  std::vector<SwimmerPath> paths_;   ///< with thermal noise: ends of base cycles [length]
  std::vector<Vec3> fluid_impulse_;  ///< FluidForces::integral at the last frame
  std::vector<SwimmerLog> logs_;   ///< one per swimmer, in the order of ids
  double largest_turn_ = 0;        ///< largest rotation of a swimmer between two samples [radian]
  std::vector<SwarmCycle> swarm_;  ///< one per base cycle; empty for a single swimmer
};

}  // namespace beadswim
