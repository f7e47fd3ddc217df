#pragma once

#include "beadswim/overdamped/overdamped_setup.hpp"
#include "beadswim/overdamped/overdamped_system.hpp"
#include "beadswim/run/model.hpp"

// Model of a run: beads with a mobility, without inertia (libs/overdamped).

namespace beadswim {

/// Description of a run with a mobility model.
struct OverdampedPlan : ModelPlan {
  /// The communicator must exist as long as the plan. Throws InputError if the layout has no-slip walls, if
  /// its box is too narrow, or if the options contain a flag that applies to the model lbm only.
  OverdampedPlan(const Layout& layout, const RunSettings& requested, const std::string& source,
                 const Communicator& communicator);

  std::unique_ptr<Model> make(const std::string& trajectory, long flow_until) const override;

  const Communicator& communicator;
  OverdampedScene scene;           ///< [units]
  double kinematic_viscosity = 0;  ///< [units]
  /// Smallest height of a bead over the wall at rest, relative to its radius; nullopt without half-space.
  std::optional<double> height_at_rest;
};

/// The mobility models rpy, rpy+near, multipole and oseen: beads without inertia in a fluid without inertia.
class OverdampedModel : public Model {
 public:
  explicit OverdampedModel(const OverdampedPlan& plan);

  void step() override { system_.step(); }
  long steps_done() const override { return system_.steps_done(); }

  int own_swimmers() const override;
  SwimmerIdentity own_swimmer(int number) const override;
  std::vector<Vec3> bead_positions(int number, double ahead) const override;
  std::vector<SwimmerPose> gather_swimmers(double ahead) const override;

  ModelTotals first_totals() const override;
  ModelTotals totals() override;
  std::optional<ModelFault> fault() const override;

  void write_flow() override {}
  void describe(RunRecord& record) const override;
  std::vector<RunWarning> warnings() const override;

  void write_history(OutgoingMessage& history) const override;
  void write_state(CheckpointWriter& checkpoint) override;
  void restore(long steps_done, IncomingMessage& history, const CheckpointReader& checkpoint) override;

 private:
  BeadMotion motion_of(std::size_t bead, double ahead) const;
  std::string message_of(const OverdampedFault& fault) const;

  const OverdampedPlan& plan_;
  std::vector<BeadRange> bead_ranges_;
  OverdampedSystem system_;
};

}  // namespace beadswim
