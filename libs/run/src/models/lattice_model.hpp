#pragma once

#include <memory>

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/coupling/scene_on_lattice.hpp"
#include "beadswim/run/model.hpp"
#include "models/flow_output.hpp"

// Model of a run: resolved beads in a lattice-Boltzmann fluid (libs/coupling).

namespace beadswim {

/// Description of a run with the model lbm (lattice Boltzmann).
struct LatticePlan : ModelPlan {
  /// The communicator must exist as long as the plan. Throws the errors of put_on_lattice()
  /// (scene_on_lattice.hpp), and InputError if the memory of the machine does not suffice. Collective.
  LatticePlan(const Layout& layout, const RunSettings& requested, const std::string& source,
              const Communicator& communicator);

  std::unique_ptr<Model> make(const std::string& trajectory, long flow_until) const override;
  const SceneOnLattice* lattice() const override { return &on_lattice; }

  const Communicator& communicator;
  SceneOnLattice on_lattice;
};

/// The model lbm: resolved beads in a lattice-Boltzmann fluid.
class LatticeModel : public Model {
 public:
  LatticeModel(const LatticePlan& plan, const std::string& trajectory, long flow_until);

  void step() override;
  long steps_done() const override { return system_->steps_done(); }

  int own_swimmers() const override { return static_cast<int>(system_->owned_swimmers().size()); }
  SwimmerIdentity own_swimmer(int number) const override;
  std::vector<Vec3> bead_positions(int number, double ahead) const override;
  std::vector<SwimmerPose> gather_swimmers(double ahead) const override;

  ModelTotals first_totals() const override { return in_layout_units(first_totals_); }
  ModelTotals totals() override;
  std::optional<ModelFault> fault() const override;

  void write_flow() override {
    if (flow_) flow_->write(*system_);
  }
  void describe(RunRecord& record) const override;
  std::vector<RunWarning> warnings() const override;

  void write_history(OutgoingMessage& history) const override;
  void write_state(CheckpointWriter& checkpoint) override;
  void restore(long steps_done, IncomingMessage& history, const CheckpointReader& checkpoint) override;

 private:
  ModelTotals in_layout_units(const SceneTotals& totals) const;
  double largest_mach() const;

  const SceneOnLattice& on_lattice_;
  const Communicator& communicator_;
  std::unique_ptr<CoupledSystem> system_;
  std::optional<FlowOutput> flow_;
  Traffic earlier_traffic_;                 ///< messages of systems that have been replaced
  long first_step_ = 0;                     ///< steps of the earlier run that this run continues
  SceneTotals first_totals_, last_totals_;  ///< at the start of the run, and most recently; in lattice units
  long last_totals_step_ = 0;
};

}  // namespace beadswim
