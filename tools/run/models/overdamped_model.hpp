#pragma once

#include "beadswim/overdamped/overdamped_setup.hpp"
#include "beadswim/overdamped/overdamped_system.hpp"
#include "models/model.hpp"

// Beads as points of a mobility, without inertia (libs/overdamped), as a run drives them.

namespace beadswim {

struct OverdampedPlan : ModelPlan {
  /// communicator: must outlive it. Throws InputError if the layout has no-slip walls or is too narrow,
  /// or options are the lattice's.
  OverdampedPlan(const Layout& layout, const RunOptions& asked, const std::string& source,
                 const Communicator& communicator);

  std::unique_ptr<Model> make(long flow_until) const override;

  const Communicator& communicator;
  OverdampedScene scene;
  double kinematic_viscosity = 0;
};

class OverdampedModel : public Model {
 public:
  explicit OverdampedModel(const OverdampedPlan& plan);

  void step() override { system_.step(); }
  long steps_done() const override { return system_.steps_done(); }

  int own_swimmers() const override;
  SwimmerName own_swimmer(int number) const override;
  std::array<Vec3, 3> bead_positions(int number, double ahead) const override;
  std::vector<SwimmerSight> gather_swimmers() const override;

  ModelTotals first_totals() const override { return {}; }
  ModelTotals totals() override { return {}; }  // no inertia, no volume flux
  std::optional<ModelFault> fault() const override;

  void write_flow() override {}
  void describe(RunRecord& record) const override;
  std::vector<std::string> warnings() const override;

  void write_past(OutgoingMessage& past) const override;
  void write_state(CheckpointWriter& checkpoint) override;
  void restore(long steps_done, IncomingMessage& past, const CheckpointReader& checkpoint) override;

 private:
  std::string message_of(const OverdampedFault& fault) const;

  const OverdampedPlan& plan_;
  OverdampedSystem system_;
};

}  // namespace beadswim
