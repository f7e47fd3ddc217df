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

// Interface between the time loop of a run and the model of the fluid. A ModelPlan describes a run and makes
// its Model.
//
// Quantities are in units of the layout. Positions and motions of beads are an exception: they are in units
// of the model [ModelUnits], so that a checkpoint stores samples without a conversion.
//
// All functions are collective, unless their comment says that they are local to one rank.

namespace beadswim {

/// Units of a model, expressed in units of the layout.
struct ModelUnits {
  double length = 1, time = 1;

  double velocity() const { return length / time; }
};

/// Id and type of a swimmer.
struct SwimmerIdentity {
  int id = 0;
  int type = 0;  ///< index into ModelPlan::periods and ModelPlan::radii
};

/// Present positions and velocities of a swimmer's beads.
struct SwimmerPose {
  int id = 0;
  Vec3 initial_axis = Vec3::UnitX();
  SwimmerMotion motion;  ///< [ModelUnits]
};

/// Sums over the complete scene.
struct ModelTotals {
  std::optional<Vec3> momentum;       ///< momentum of fluid and beads [mass length/time]
  Vec3 mean_flow = Vec3::Zero();      ///< velocity of fluid and beads, averaged over the volume [length/time]
  std::optional<double> mass_excess;  ///< mass relative to the fluid at rest, minus 1
};

/// Fault that ends a run.
struct ModelFault {
  RunStatus status = RunStatus::failed;  ///< failed or stopped_speed
  std::string message;                   ///< place, fault, likely cause and remedy, for users
};

/// Swimmers in a fluid, advanced step by step.
class Model {
 public:
  Model() = default;
  virtual ~Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  /// Advances by one time step. Does not throw if the state becomes unphysical; fault() then returns the
  /// fault.
  virtual void step() = 0;
  /// Returns the number of steps since the start of the run, including steps of runs that it continues.
  /// Local.
  virtual long steps_done() const = 0;

  /// Returns the number of swimmers that this rank owns until the next step. Local.
  virtual int own_swimmers() const = 0;
  /// Returns id and type of an own swimmer, numbered from 0. Local.
  virtual SwimmerIdentity own_swimmer(int number) const = 0;
  /// Returns the bead positions of an own swimmer at the present time plus `ahead`, to second order in
  /// `ahead` [ModelUnits]. `ahead`: fraction of a step, positive or negative. Local.
  virtual std::array<Vec3, 3> bead_positions(int number, double ahead) const = 0;
  /// Returns all swimmers in the order of their ids on rank 0, and an empty list on other ranks.
  virtual std::vector<SwimmerPose> gather_swimmers() const = 0;

  virtual ModelTotals first_totals() const = 0;  ///< totals at the start of the run
  virtual ModelTotals totals() = 0;              ///< evaluates the present totals
  /// Returns the first fault on any rank, or nullopt. The totals are checked only if they were evaluated
  /// after the last step. Returns the same on all ranks.
  virtual std::optional<ModelFault> fault() const = 0;

  /// Writes the present flow fields if the options of the plan request flow fields.
  virtual void write_flow() = 0;
  /// Adds the data of the model to a record that contains status, momentum and cost.
  virtual void describe(RunRecord& record) const = 0;
  /// Returns warnings on the steps done that may have impaired the results, one line each.
  virtual std::vector<std::string> warnings() const = 0;

  /// Writes the history of the run that a checkpoint keeps (few numbers, on rank 0).
  virtual void write_history(OutgoingMessage& history) const = 0;
  /// Writes the state, from which the run continues, as sections of a checkpoint.
  virtual void write_state(CheckpointWriter& checkpoint) = 0;
  /// Restores the history and the state of a run that had completed `steps_done` steps.
  virtual void restore(long steps_done, IncomingMessage& history, const CheckpointReader& checkpoint) = 0;
};

/// Description of a run that is known before memory for its model is allocated.
struct ModelPlan {
  ModelPlan() = default;
  virtual ~ModelPlan() = default;
  ModelPlan(const ModelPlan&) = delete;
  ModelPlan& operator=(const ModelPlan&) = delete;

  /// Makes the model in its initial state. `flow_until`: step up to which an earlier run has written flow
  /// fields. The plan must outlive the model. Throws InputError on all ranks.
  virtual std::unique_ptr<Model> make(long flow_until) const = 0;

  RunOptions options;  ///< requested options, with the choices of the plan for those left open
  ModelUnits units;
  double base_period = 0;                    ///< duration of one cycle of the run [time]
  double time_step = 0;                      ///< [time]
  long steps_per_cycle = 0;                  ///< time steps per base cycle
  std::vector<double> periods;               ///< driving period of each type [step]
  std::vector<std::array<double, 3>> radii;  ///< radii of beads 1, 2, 3 of each type [length]
  std::vector<PlacedSwimmer> swimmers;       ///< in the order of their ids [ModelUnits]
  std::optional<double> cells;               ///< number of lattice cells; nullopt without a lattice
  std::string announcement;                  ///< description of the run, one line
  std::vector<std::string> warnings;         ///< warnings that are known before the run, one line each
};

}  // namespace beadswim
