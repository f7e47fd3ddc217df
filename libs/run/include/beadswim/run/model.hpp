#pragma once

#include <fmt/core.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/compare/run_uncertainty.hpp"
#include "beadswim/core/message.hpp"
#include "beadswim/core/round_up.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/io/checkpoint_file.hpp"
#include "beadswim/run/flow_request.hpp"
#include "beadswim/run/run_length.hpp"
#include "beadswim/run/run_settings.hpp"
#include "beadswim/scene/placed_swimmers.hpp"
#include "beadswim/scene/unit_scales.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"

// Interface between the time loop of a run and the physical model, which moves fluid and beads. A ModelPlan
// describes a run before it begins and makes its Model.
//
// Quantities have the units of the layout. Positions and motions of beads are an exception: they have the
// units of the model [ModelPlan::units], so that checkpoints store them without conversion.
//
// All functions are collective, except those whose comment says "Local", which any rank may call alone.

namespace beadswim {

/// Id and type of a swimmer.
struct SwimmerIdentity {
  int id = 0;
  int type = 0;  ///< index into ModelPlan::periods and ModelPlan::radii
};

/// Momentum, mean flow and mass of the scene.
struct ModelTotals {
  std::optional<Vec3> momentum;       ///< momentum of fluid and beads [mass length/time]
  Vec3 mean_flow = Vec3::Zero();      ///< velocity of fluid and beads, averaged over the volume [length/time]
  std::optional<double> mass_excess;  ///< mass relative to the fluid at rest, minus 1
};

/// Flow at a point, in units of the layout.
struct PointFlow {
  Vec3 velocity = Vec3::Zero();      ///< inside a bead that of the bead
  std::optional<double> pressure{};  ///< relative to the fluid at rest; nullopt: the model has none
  double bead =
      0;  ///< number of the bead around the point; 0: none; of a mean: share of the time within beads

  BEADSWIM_FIELDS(velocity, pressure, bead)
};

/// Forces of the fluid on all beads. Where they fluctuate, only their integral over time is given.
struct FluidForces {
  std::vector<Vec3> present{};
  std::vector<Vec3> integral{};  ///< sum over all steps of the force in the step
};

/// Appends a warning. Its message is a format of fmt with its values.
template <class... Values>
void add_warning(std::vector<RunWarning>& warnings, const char* code, fmt::format_string<Values...> message,
                 Values&&... values) {
  warnings.push_back({code, fmt::format(message, std::forward<Values>(values)...)});
}

/// Status and reason with which a run ends before its last step.
struct EarlyStop {
  RunStatus status = RunStatus::stopped_signal;
  std::string reason;  ///< of a fault: place, fault, likely cause and remedy, for users
};

/// Swimmers in a fluid, which are advanced in time steps.
class Model {
 public:
  Model() = default;
  virtual ~Model() = default;
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  /// Advances fluid and beads by one time step. If the state becomes unphysical, step() does not throw;
  /// fault() then returns the fault.
  virtual void step() = 0;
  /// Returns the number of time steps since time 0, including the steps of earlier runs that this run
  /// continues. Local.
  virtual long steps_done() const = 0;

  /// Returns the number of swimmers that this rank owns. It can change in the next step. Local.
  virtual int own_swimmers() const = 0;
  /// Returns id and type of a swimmer that this rank owns. `number`: index from 0 to own_swimmers() - 1.
  /// Local.
  virtual SwimmerIdentity own_swimmer(int number) const = 0;
  /// Returns the bead positions of a swimmer that this rank owns at the present time plus `ahead` time steps
  /// [ModelPlan::units]. `number`: index from 0 to own_swimmers() - 1. `ahead`: a fraction, positive or
  /// negative. The error is proportional to ahead^3. Local.
  virtual std::vector<Vec3> bead_positions(int number, double ahead) const = 0;
  /// Returns the present force dipoles of all swimmers that this rank owns [ModelPlan::units]. Local.
  virtual std::vector<DipoleSample> dipoles() const = 0;
  /// Returns the beads of all swimmers, in the order of their ids, on rank 0, and an empty list on other
  /// ranks [ModelPlan::units]. Positions and velocities are those at the present time plus `ahead` time
  /// steps, as above.
  virtual std::vector<SwimmerMotion> gather_swimmers(double ahead) const = 0;

  /// Returns the present forces of the fluid on all beads, in the order of gather_swimmers(), on rank 0
  /// [ModelPlan::units].
  virtual FluidForces gather_fluid_forces() const = 0;

  virtual ModelTotals first_totals() const = 0;  ///< totals at the start of the run
  virtual ModelTotals totals() = 0;              ///< evaluates the present totals
  /// Returns the first fault (unphysical state) that any rank has found, with the status failed or
  /// stopped_speed; nullopt if there is none. The result is the same on all ranks. Total mass and momentum
  /// are checked only if totals() was called after the last step.
  virtual std::optional<EarlyStop> fault() const = 0;

  /// Returns the present flow at points in the box [length], complete on rank 0.
  virtual std::vector<PointFlow> flow_at(std::span<const Vec3> points) = 0;
  /// Writes the present flow on all cells of the lattice, one file per level of cells
  /// (ModelPlan::flow_levels()).
  virtual void write_flow(const std::vector<std::string>& /*files*/) const {}
  /// Adds the data that only this model has to a record that already contains status, momentum and cost.
  virtual void describe(RunRecord& record) const = 0;
  /// Returns warnings about states during the run that may have made the results less accurate.
  virtual std::vector<RunWarning> warnings() const = 0;

  /// Writes the extreme values of the run until now, such as largest speed and smallest gap, for a
  /// checkpoint, and what else restore() needs to make the model. Only rank 0 writes data.
  virtual void write_history(OutgoingMessage& history) const = 0;
  /// Writes the state of fluid and beads, from which a run can continue, as sections of a checkpoint.
  virtual void write_state(CheckpointWriter& checkpoint) = 0;
  /// Restores extreme values and state from the checkpoint of a run that had completed `steps_done` time
  /// steps.
  virtual void restore(long steps_done, IncomingMessage& history, const CheckpointReader& checkpoint) = 0;
};

/// Description of a run, made before the memory for its model is allocated.
struct ModelPlan {
  ModelPlan() = default;
  virtual ~ModelPlan() = default;
  ModelPlan(const ModelPlan&) = delete;
  ModelPlan& operator=(const ModelPlan&) = delete;

  /// Makes the model in its initial state. The plan must exist as long as the model. Throws InputError on all
  /// ranks.
  virtual std::unique_ptr<Model> make() const = 0;
  /// Returns the scene on the lattice of the run; nullptr for models without a lattice. Local.
  virtual const SceneOnLattice* lattice() const { return nullptr; }
  /// Returns the number of levels of cells; 0 without a lattice. Local.
  virtual int flow_levels() const { return 0; }

  /// Rounds a number of steps up to a multiple of step_multiple.
  long whole_steps(long steps) const { return round_up_to_multiple(steps, step_multiple); }
  /// Returns the number of steps of a run of `cycles` base cycles.
  long steps_in(double cycles) const { return whole_steps(total_steps(cycles, steps_per_cycle)); }

  RunSettings settings;                    ///< settings of the run, completed by the plan
  std::optional<FlowRequest> flow;         ///< where flow is written; nullopt: nowhere
  UnitScales units;                        ///< of the model, in the units of the layout
  double base_period = 0;                  ///< duration of one cycle of the run [time]
  double time_step = 0;                    ///< [time]
  long steps_per_cycle = 0;                ///< time steps per base cycle
  long steps_done = 0;                     ///< time steps of the earlier run that this run continues
  std::vector<double> periods;             ///< driving period of each type [step]
  std::vector<std::vector<double>> radii;  ///< radii of the beads of each type [length]
  std::vector<PlacedSwimmer> swimmers;     ///< in the order of their ids [ModelPlan::units]
  /// The state can be written, and the run can end, after a multiple of this number of steps.
  long step_multiple = 1;
  std::string announcement;                ///< description of the run, one line
  std::optional<ExpectedErrors> expected;  ///< on rank 0, set by the caller; nullopt: unknown
  std::vector<RunWarning> warnings;        ///< warnings that are known before the run
};

}  // namespace beadswim
