#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/message.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "beadswim/scene/placed_swimmers.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"
#include "command_line/options.hpp"

// What a run drives: swimmers in a fluid, whatever the model of the fluid. A ModelPlan says what the run will
// be, and makes the Model. All is in the layout's units, but for motions and positions of beads, which are in
// the model's own: samples in checkpoints stay the numbers that the model has. All ranks call everything
// together unless a function says that it is one rank's own.

namespace beadswim {

/// A model's units, in the layout's.
struct ModelUnits {
  double length = 1, time = 1;

  double velocity() const { return length / time; }
};

/// A swimmer, and whose driving it has.
struct SwimmerName {
  int id = 0;
  int type = 0;  ///< index into ModelPlan::periods
};

/// A swimmer as it is now.
struct SwimmerSight {
  int id = 0;
  Vec3 initial_axis = Vec3::UnitX();
  SwimmerMotion motion;  ///< [ModelUnits]
};

/// Sums over the whole scene.
struct ModelTotals {
  std::optional<Vec3> momentum;       ///< of fluid and beads [mass length/time]
  Vec3 mean_flow = Vec3::Zero();      ///< volume mean of the velocity of fluid and beads [length/time]
  std::optional<double> mass_excess;  ///< beyond the resting fluid's, relative to that
};

/// Why a run cannot go on.
struct ModelFault {
  RunStatus status = RunStatus::failed;  ///< or stopped_speed
  std::string message;                   ///< where, what, the likely cause and what to change, for people
};

class Model {
 public:
  Model() = default;
  virtual ~Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  /// What becomes unphysical is noted, not thrown: fault() tells.
  virtual void step() = 0;
  /// Of the whole run; one rank's own.
  virtual long steps_done() const = 0;

  /// Swimmers that this rank moves, numbered from 0, until the next step; these three are one rank's own.
  virtual int own_swimmers() const = 0;
  virtual SwimmerName own_swimmer(int number) const = 0;
  /// Where its beads are `ahead` of now, a part of a step before or after, to second order [ModelUnits].
  virtual std::array<Vec3, 3> bead_positions(int number, double ahead) const = 0;
  /// All swimmers in order of their ids on rank 0; empty elsewhere.
  virtual std::vector<SwimmerSight> gather_swimmers() const = 0;

  virtual ModelTotals first_totals() const = 0;  ///< at the run's start
  virtual ModelTotals totals() = 0;
  /// The first of what has gone wrong on any rank, in steps or in the totals if they were taken after this
  /// one; alike on all ranks.
  virtual std::optional<ModelFault> fault() const = 0;

  /// Writes the fields of the flow as they are now, if the plan's options ask for any.
  virtual void write_flow() = 0;
  /// Adds what it alone knows to a record that has status, momentum and cost.
  virtual void describe(RunRecord& record) const = 0;
  /// What, of the steps done, may have made results wrong, each a line for people.
  virtual std::vector<std::string> warnings() const = 0;

  /// A checkpoint: few numbers of its past on rank 0, and sections that the future follows from.
  virtual void write_past(OutgoingMessage& past) const = 0;
  virtual void write_state(CheckpointWriter& checkpoint) = 0;
  virtual void restore(long steps_done, IncomingMessage& past, const CheckpointReader& checkpoint) = 0;
};

/// What is known of a model's run before it takes memory for it.
struct ModelPlan {
  ModelPlan() = default;
  virtual ~ModelPlan() = default;
  ModelPlan(const ModelPlan&) = delete;
  ModelPlan& operator=(const ModelPlan&) = delete;

  /// The model at its start. Fields of the flow up to step `flow_until` are there from an earlier run. Throws
  /// InputError alike on all ranks. The plan must outlive it.
  virtual std::unique_ptr<Model> make(long flow_until) const = 0;

  RunOptions options;  ///< with what the plan chose where they left it open
  ModelUnits units;
  double base_period = 0;  ///< by which cycles of the run are counted [time]
  double time_step = 0;    ///< [time]
  long steps_per_cycle = 0;
  std::vector<double> periods;               ///< of each type's driving [step]
  std::vector<std::array<double, 3>> radii;  ///< of each type's beads 1, 2, 3 [length]
  std::vector<PlacedSwimmer> swimmers;       ///< in order of their ids [ModelUnits]
  std::optional<double> cells;               ///< none: no lattice
  std::string announcement;                  ///< what the run is, in a line
  std::vector<std::string> warnings;         ///< what may go wrong, each a line
};

}  // namespace beadswim
