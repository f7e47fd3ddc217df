#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "beadswim/core/error.hpp"
#include "beadswim/coupling/lattice_memory.hpp"
#include "beadswim/coupling/refinement.hpp"
#include "beadswim/run/velocity_roundoff.hpp"
#include "models/lattice_flow.hpp"
#include "models/lattice_model.hpp"
#include "models/models.hpp"

namespace beadswim {
namespace {

std::string announcement_of(const SceneOnLattice& on_lattice, const Communicator& communicator) {
  const Index3& cells = on_lattice.scene.cells;
  const LatticeChoice& lattice = on_lattice.lattice;
  const std::vector<Block> levels = on_lattice.scene.all_levels();
  const std::string size =
      levels.size() > 1
          ? fmt::format("{:.3g} cells on {} levels, the finest", cells_on_levels(levels), levels.size())
          : fmt::format("{} x {} x {} cells", cells[0], cells[1], cells[2]);
  return fmt::format(
      "{} of {:.6g}, time step {:.6g}, relaxation time {:.6g}, {} steps per cycle, {} swimmers, {} "
      "precision, {:.2g} GB on {} ranks",
      size, lattice.scales.length, lattice.scales.time, lattice.relaxation_time, lattice.steps_per_period,
      on_lattice.scene.swimmers.size(), to_text(on_lattice.scene.precision),
      1e-9 * lattice_bytes(on_lattice.scene), communicator.size());
}

/// Returns position and velocity of a bead `ahead` time steps later. `next`: its velocity at the end of the
/// next step.
BeadMotion extrapolated(BeadMotion bead, const BeadVelocity& next, double ahead) {
  const Vec3 acceleration = next.linear - bead.velocity;  // velocity change per step
  bead.position = bead.position + ahead * bead.velocity + 0.5 * ahead * ahead * acceleration;
  bead.velocity += ahead * acceleration;
  return bead;
}

/// Returns the scene with the levels of a checkpoint. Throws DataError if they cannot be those of the run.
CoupledScene with_levels(CoupledScene scene, std::vector<Block> levels, const std::string& path) {
  const auto fits = [&](const Block& level) {
    return !level.is_empty() && (level.size <= scene.cells).all();
  };
  if (levels.size() != scene.levels.size() || !std::ranges::all_of(levels, fits) ||
      levels.front() != scene.levels.front())
    throw DataError(path, "the levels of cells in the checkpoint are damaged");
  scene.levels = std::move(levels);
  return scene;
}

struct LatticePlan : ModelPlan {
  LatticePlan(const Layout& layout, const RunSettings& requested, const std::string& source,
              const Communicator& ranks)
      : communicator(ranks), on_lattice(put_on_lattice(layout, requested.lattice, source)) {
    require_memory(on_lattice.scene, communicator);
    const LatticeChoice& lattice = on_lattice.lattice;
    settings = requested;
    settings.lattice.cells_per_radius = on_lattice.resolution.cells_per_radius;
    settings.lattice.relaxation_time = on_lattice.resolution.relaxation_time;
    units = lattice.scales;
    base_period = on_lattice.period;
    time_step = lattice.scales.time;
    steps_per_cycle = lattice.steps_per_period;
    for (const SwimmerType& type : on_lattice.scene.types) {
      periods.push_back(type.driving.period);
      std::vector<double>& of_type = radii.emplace_back();
      for (const Bead& bead : type.beads) of_type.push_back(bead.radius * units.length);
    }
    swimmers = on_lattice.scene.swimmers;
    step_multiple = 1L << (on_lattice.scene.all_levels().size() - 1);
    announcement = announcement_of(on_lattice, communicator);
    const long steps = total_steps(settings.cycles, steps_per_cycle);
    warnings = warnings_before(on_lattice, velocity_roundoff(on_lattice.scene, steps_per_cycle, steps));
  }

  std::unique_ptr<Model> make() const override;
  int flow_levels() const override { return static_cast<int>(on_lattice.scene.all_levels().size()); }
  const SceneOnLattice* lattice() const override { return &on_lattice; }

  const Communicator& communicator;
  SceneOnLattice on_lattice;
};

class LatticeModel : public Model {
 public:
  explicit LatticeModel(const LatticePlan& plan)
      : on_lattice_(plan.on_lattice),
        communicator_(plan.communicator),
        system_(std::make_unique<CoupledSystem>(on_lattice_.scene, communicator_)),
        first_totals_(system_->totals()),
        last_totals_(first_totals_) {}

  void step() override {
    system_->step();
    auto moved = with_levels_around_beads(*system_, communicator_);
    if (!moved) return;
    earlier_traffic_.add(system_->traffic());
    system_ = std::move(moved);
  }
  long steps_done() const override { return system_->steps_done(); }

  int own_swimmers() const override { return static_cast<int>(system_->owned_swimmers().size()); }
  SwimmerIdentity own_swimmer(int number) const override {
    const SwimmerState& swimmer = system_->owned_swimmers()[number];
    return {.id = swimmer.id, .type = swimmer.type};
  }

  std::vector<Vec3> bead_positions(int number, double ahead) const override {
    const SwimmerState& swimmer = system_->owned_swimmers()[number];
    std::vector<Vec3> positions;
    for (std::size_t b = 0; b < swimmer.motion.size(); ++b)
      positions.push_back(extrapolated(swimmer.motion[b], swimmer.predicted[b], ahead).position);
    return positions;
  }

  std::vector<DipoleSample> dipoles() const override {
    std::vector<DipoleSample> dipoles;
    for (const SwimmerState& swimmer : system_->owned_swimmers())
      dipoles.push_back({.integral = swimmer.dipole_sum});
    return dipoles;
  }

  std::vector<SwimmerMotion> gather_swimmers(double ahead) const override {
    std::vector<SwimmerMotion> swimmers;
    for (const SwimmerState& swimmer : system_->gather_swimmers()) {
      SwimmerMotion& motion = swimmers.emplace_back();
      for (std::size_t b = 0; b < swimmer.motion.size(); ++b)
        motion.push_back(extrapolated(swimmer.motion[b], swimmer.predicted[b], ahead));
    }
    return swimmers;
  }

  FluidForces gather_fluid_forces() const override {
    FluidForces forces;
    for (const SwimmerState& swimmer : system_->gather_swimmers())
      forces.integral.insert(forces.integral.end(), swimmer.fluid_impulse.begin(),
                             swimmer.fluid_impulse.end());
    return forces;
  }

  ModelTotals first_totals() const override { return in_layout_units(first_totals_); }
  ModelTotals totals() override {
    last_totals_ = system_->totals();
    last_totals_step_ = steps_done();
    return in_layout_units(last_totals_);
  }

  std::optional<EarlyStop> fault() const override {
    std::optional<Fault> fault = system_->fault();
    if (!fault && last_totals_step_ == steps_done()) {
      fault =
          conservation_fault(on_lattice_.scene, first_totals_, last_totals_, system_->largest_bead_speed());
      if (fault) fault->step = steps_done();
    }
    if (!fault) return std::nullopt;
    return model_fault(*fault, faulty_run(*fault, on_lattice_, largest_mach()));
  }

  std::vector<PointFlow> flow_at(std::span<const Vec3> points) override {
    return LatticeFlow(*system_, on_lattice_.lattice.scales, communicator_).at(points);
  }
  void write_flow(const std::vector<std::string>& files) const override {
    LatticeFlow(*system_, on_lattice_.lattice.scales, communicator_).write(files);
  }
  void describe(RunRecord& record) const override {
    Traffic traffic = earlier_traffic_;
    traffic.add(system_->traffic());
    describe_lattice_run(record, *system_, on_lattice_, traffic, steps_done() - first_step_, communicator_);
  }
  std::vector<RunWarning> warnings() const override { return warnings_after(largest_mach()); }

  void write_history(OutgoingMessage& history) const override {
    history(system_->progress(), first_totals_);
    if (!on_lattice_.scene.levels.empty()) history(system_->scene().levels);
  }
  void write_state(CheckpointWriter& checkpoint) override { write_lattice_state(checkpoint, *system_); }
  void restore(long steps_done, IncomingMessage& history, const CheckpointReader& checkpoint) override {
    SystemProgress progress{.steps_done = steps_done};
    history(progress, first_totals_);
    if (!on_lattice_.scene.levels.empty()) {
      std::vector<Block> levels;
      history(levels);
      system_.reset();
      system_ = std::make_unique<CoupledSystem>(with_levels(on_lattice_.scene, levels, checkpoint.path()),
                                                communicator_);
    }
    read_lattice_state(checkpoint, *system_, progress);
    first_step_ = steps_done;
  }

 private:
  ModelTotals in_layout_units(const SceneTotals& totals) const {
    const UnitScales& scales = on_lattice_.lattice.scales;
    return {.momentum = totals.momentum * scales.momentum(),
            .mean_flow = totals.mean_flow * scales.velocity(),
            .mass_excess = totals.mass_excess};
  }
  double largest_mach() const { return system_->largest_bead_speed() * std::sqrt(3.0); }

  const SceneOnLattice& on_lattice_;
  const Communicator& communicator_;
  std::unique_ptr<CoupledSystem> system_;
  Traffic earlier_traffic_;                 ///< messages of systems that have been replaced
  long first_step_ = 0;                     ///< steps of the earlier run that this run continues
  SceneTotals first_totals_, last_totals_;  ///< at the start of the run, and most recently; in lattice units
  long last_totals_step_ = 0;
};

std::unique_ptr<Model> LatticePlan::make() const {
  try {
    return std::make_unique<LatticeModel>(*this);
  } catch (const std::bad_alloc&) {
    throw SolverError(
        fmt::format("out of memory: the lattice needs about {:.2g} GB on {} ranks; use a smaller {}, {} "
                    "single, a smaller box, more machines, or a higher limit (ulimit -v)",
                    1e-9 * lattice_bytes(on_lattice.scene), communicator.size(), Setting::cells_per_radius,
                    Setting::precision));
  }
}

}  // namespace

std::unique_ptr<ModelPlan> lattice_plan(const Layout& layout, const RunSettings& requested,
                                        const std::string& source, const Communicator& communicator) {
  return std::make_unique<LatticePlan>(layout, requested, source, communicator);
}

}  // namespace beadswim
