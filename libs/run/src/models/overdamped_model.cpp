#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "beadswim/core/sha256.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "beadswim/overdamped/overdamped_setup.hpp"
#include "beadswim/overdamped/overdamped_system.hpp"
#include "beadswim/scene/bead_gaps.hpp"
#include "models/fault_message.hpp"
#include "models/models.hpp"
#include "run_parts.hpp"

namespace beadswim {
namespace {

constexpr const char *beads_section = "overdamped", *memory_section = "memory";

/// Run with lubrication at the wall of a half-space, for warnings.
std::string lattice_over_wall() {
  return fmt::format("{} lbm in a box with the boundary no-slip across the wall", Setting::model);
}

struct OverdampedPlan : ModelPlan {
  OverdampedPlan(const Layout& layout, const RunSettings& requested, const std::string& source,
                 const Communicator& ranks)
      : communicator(ranks) {
    settings = requested;
    OverdampedSetup setup = overdamped_setup(layout, *mobility_model(requested.model), requested.mobility,
                                             requested.frames_per_cycle, source);
    scene = std::move(setup.scene);
    units = setup.units;
    kinematic_viscosity = layout.fluid.kinematic_viscosity / (units.length * units.velocity());
    swimmers = scene.swimmers;
    if (const auto& half_space = layout.domain.half_space)
      height_at_rest = smallest_relative_height(placed_beads(layout), *half_space);
    base_period = setup.base_period;
    steps_per_cycle = setup.steps_per_cycle;
    time_step = scene.step * units.time;
    for (const SwimmerType& type : scene.types) {
      periods.push_back(type.driving.period / scene.step);
      std::vector<double>& of_type = radii.emplace_back();
      for (const Bead& bead : type.beads) of_type.push_back(bead.radius * units.length);
    }
    if (scene.memory && !layout.domain.box)
      add_warning(warnings, "periodic-cube",
                  "the model unsteady replaces open space by a periodic cube of edge {:.6g}; its images "
                  "change the velocity of a lone swimmer by some 0.2 %",
                  scene.domain.box->lengths[0] * units.length);
    announcement = fmt::format(
        "model {}, {} swimmers in {}, relative tolerance {:.3g} of the bead velocities, {} steps per cycle, "
        "on {} ranks",
        to_text(scene.model), swimmers.size(), in_words(layout.domain), scene.tolerance, steps_per_cycle,
        communicator.size());
  }

  std::unique_ptr<Model> make() const override;

  const Communicator& communicator;
  OverdampedScene scene;           ///< [units]
  double kinematic_viscosity = 0;  ///< [units]
  /// Smallest height of a bead over the wall at rest, relative to its radius; nullopt without half-space.
  std::optional<double> height_at_rest;
};

class OverdampedModel : public Model {
 public:
  explicit OverdampedModel(const OverdampedPlan& plan)
      : plan_(plan), bead_ranges_(bead_ranges(plan.scene)), system_(plan.scene, plan.communicator) {}

  void step() override { system_.step(); }
  long steps_done() const override { return system_.steps_done(); }

  int own_swimmers() const override {
    const auto [first, last] = system_.own_swimmers();
    return static_cast<int>(last - first);
  }

  SwimmerIdentity own_swimmer(int number) const override {
    const PlacedSwimmer& swimmer = plan_.swimmers[system_.own_swimmers().first + number];
    return {.id = swimmer.id, .type = swimmer.type};
  }

  std::vector<Vec3> bead_positions(int number, double ahead) const override {
    const auto [first, last] = bead_ranges_[system_.own_swimmers().first + number];
    std::vector<Vec3> positions;
    for (std::size_t b = first; b < last; ++b) positions.push_back(motion_of(b, ahead).position);
    return positions;
  }

  std::vector<DipoleSample> dipoles() const override {
    const std::span<const double> moments = system_.moments();
    const std::size_t per_bead = moments.size() / system_.positions().size();
    std::vector<DipoleSample> dipoles;
    for (int number = 0; number < own_swimmers(); ++number) {
      const auto [first, last] = bead_ranges_[system_.own_swimmers().first + number];
      BeadVectors positions(3, last - first), forces(3, last - first);
      Eigen::Matrix3d stresslets = Eigen::Matrix3d::Zero();
      for (std::size_t b = first; b < last; ++b) {
        const double* of_bead = &moments[per_bead * b];
        positions.col(b - first) = system_.positions()[b];
        forces.col(b - first) = Vec3(of_bead[0], of_bead[1], of_bead[2]);
        if (per_bead > 3) stresslets += stresslet_of(of_bead + 3);
      }
      dipoles.push_back({.present = components_of(dipole_of_forces(positions, forces) + stresslets)});
    }
    return dipoles;
  }

  std::vector<SwimmerMotion> gather_swimmers(double ahead) const override {
    std::vector<SwimmerMotion> swimmers;
    if (!plan_.communicator.is_root()) return swimmers;
    for (const auto& [first, last] : bead_ranges_) {
      SwimmerMotion& motion = swimmers.emplace_back();
      for (std::size_t b = first; b < last; ++b) motion.push_back(motion_of(b, ahead));
    }
    return swimmers;
  }

  FluidForces gather_fluid_forces() const override { return {.present = system_.fluid_forces()}; }

  // Without inertia, momentum is not defined and the mean flow is zero. With inertia, all is at rest at
  // first.
  ModelTotals first_totals() const override {
    if (!plan_.scene.memory) return {};
    return {.momentum = Vec3::Zero(), .mean_flow = Vec3::Zero(), .mass_excess = std::nullopt};
  }

  ModelTotals totals() override {
    if (!plan_.scene.memory) return {};
    return {.momentum = system_.momentum() * plan_.units.momentum(),
            .mean_flow = system_.mean_flow() * plan_.units.velocity(),
            .mass_excess = std::nullopt};
  }

  std::optional<EarlyStop> fault() const override {
    if (!system_.fault()) return std::nullopt;
    const bool is_oseen = plan_.scene.model == MobilityModel::oseen;
    return model_fault(
        *system_.fault(),
        {.length = plan_.units.length,
         .steps_per_cycle = plan_.steps_per_cycle,
         .mach = std::nullopt,
         .cause = {},
         .other_model =
             is_oseen ? fmt::format(", or use {} rpy, which is also stable for close beads", Setting::model)
                      : ""});
  }

  std::vector<PointFlow> flow_at(std::span<const Vec3> points) override {
    std::vector<Vec3> places;  // [units]
    for (const Vec3& point : points)
      places.push_back(wrapped(point / plan_.units.length, plan_.scene.domain.box));
    const FlowAtPoints flow = system_.flow_at(places);
    std::vector<PointFlow> result;
    for (std::size_t p = 0; p < points.size(); ++p) {
      PointFlow& at = result.emplace_back(PointFlow{.velocity = flow.velocities[p] * plan_.units.velocity()});
      if (flow.spheres[p] >= 0) at.bead = 1.0 + number_in_swimmer(flow.spheres[p]);
    }
    return result;
  }
  void describe(RunRecord& record) const override {
    const OverdampedState& state = system_.state();
    record.model = to_text(plan_.scene.model);
    record.dimensionless =
        dimensionless_numbers(plan_.scene.types, state.largest_speed, plan_.kinematic_viscosity,
                              plan_.base_period / plan_.units.time);
    const std::optional<EwaldPlan>& sums = system_.mobility().plan();
    const bool is_multipole = has_moment_order(plan_.scene.model);
    const double length = plan_.units.length;
    record.mobility = MobilityRecord{
        .time_step = plan_.time_step,
        .steps_per_cycle = plan_.steps_per_cycle,
        .tolerance = plan_.scene.tolerance,
        .products = state.work.products,
        .multipole_order = is_multipole ? std::optional(plan_.scene.moment_order) : std::nullopt,
        .reynolds_stress =
            plan_.scene.memory ? std::optional(plan_.scene.memory->has_reynolds_stress) : std::nullopt,
        .iterations = is_multipole ? std::optional<std::int64_t>(state.work.iterations) : std::nullopt,
        .residual = is_multipole ? std::optional(state.work.residual) : std::nullopt,
        .cut_off = sums ? std::optional(sums->cutoff * length) : std::nullopt,
        .mesh_spacing = sums ? std::optional(sums->spacing * length) : std::nullopt,
        .smallest_gap =
            std::isfinite(state.smallest_gap) ? std::optional(state.smallest_gap * length) : std::nullopt};
    if (const double thermal_energy = plan_.scene.thermal_energy; thermal_energy > 0)
      record.thermal = ThermalRecord{.thermal_energy = thermal_energy * plan_.units.energy(),
                                     .seed = static_cast<std::int64_t>(plan_.scene.seed),
                                     .noise_tolerance = plan_.scene.noise_tolerance,
                                     .noise_error = state.noise_error};
    if (system_.fault()) return;
    Sha256 hash;
    std::vector<Vec3> positions;  // [length]
    for (const Vec3& position : system_.positions()) positions.push_back(position * length);
    hash.update(std::as_bytes(std::span(positions)));
    record.state_sha256 = hash.hexadecimal();
  }

  std::vector<RunWarning> warnings() const override {
    std::vector<RunWarning> warnings;
    if (plan_.height_at_rest && !system_.fault()) {
      const MobilitySettings& settings = plan_.settings.mobility;
      const auto error_at = [&](double height) {
        return error_near_wall(height, plan_.scene.model, settings);
      };
      constexpr double notable = 0.01;
      const double height = system_.state().smallest_relative_height, error = error_at(height);
      const bool is_best =
          has_moment_order(plan_.scene.model) && settings.multipole_order == max_moment_order;
      if (error > error_at(*plan_.height_at_rest) + notable)
        add_warning(
            warnings, "wall-approach",
            "the height of a bead over the wall fell to {:.3g} radii, where its mobility has an error of up "
            "to {}; an expected error is for the height of {:.3g} radii at rest; compare this run with {}",
            height, in_percent(error), *plan_.height_at_rest,
            is_best ? lattice_over_wall()
                    : fmt::format("{} multipole {} 2", Setting::model, Setting::multipole_order));
    }
    const double gap = system_.state().smallest_gap * plan_.units.length;
    if (!std::isfinite(gap)) return warnings;
    const bool is_over_wall = plan_.scene.domain.half_space.has_value();
    const bool knows_films = plan_.scene.model == MobilityModel::rpy_near;
    add_warning(warnings, "repulsion",
                "beads came within a gap of {:.3g} of each other or of a wall and were repelled; {}; compare "
                "this run with {}",
                gap,
                knows_films
                    ? "this repulsion is artificial and not a physical force"
                    : "the model of this run neglects lubrication by the fluid film between close surfaces",
                is_over_wall ? lattice_over_wall() : fmt::format("a run by {} lbm", Setting::model));
    return warnings;
  }

  void write_history(OutgoingMessage& history) const override { history(system_.state()); }

  void write_state(CheckpointWriter& checkpoint) override {
    OutgoingMessage message;
    if (plan_.communicator.is_root())
      OverdampedState::visit_bead_fields([&](const char*, const auto& lists) { message(lists); },
                                         system_.state());
    checkpoint.add(beads_section, message.bytes());
    if (!plan_.scene.memory) return;
    OutgoingMessage memory;
    memory(system_.mobility().gather_memory());
    checkpoint.add(memory_section, memory.bytes());
  }

  void restore(long steps_done, IncomingMessage& history, const CheckpointReader& checkpoint) override {
    OverdampedState state;
    state.steps_done = steps_done;
    history(state);
    IncomingMessage message(checkpoint.bytes(beads_section));
    OverdampedState::visit_bead_fields([&](const char*, auto& lists) { message(lists); }, state);
    if (!message.is_at_end()) refuse_other_version(checkpoint);
    std::vector<double> memory;
    if (plan_.scene.memory) IncomingMessage(checkpoint.bytes(memory_section))(memory);
    system_.restore(std::move(state), memory);
  }

 private:
  int number_in_swimmer(std::size_t bead) const {
    return static_cast<int>(bead -
                            (std::ranges::upper_bound(bead_ranges_, bead, {}, &BeadRange::first) - 1)->first);
  }

  BeadMotion motion_of(std::size_t bead, double ahead) const {
    const OverdampedState& state = system_.state();
    const double time = ahead * plan_.scene.step;
    const Vec3& velocity = state.velocities[0][bead];
    const Vec3 gained = velocity - state.velocities[1][bead];  // change in the last step
    BeadMotion motion;
    if (!state.smooth.empty()) {  // the noise of the next step is unknown
      motion.position = state.positions[0][bead] + std::min(time, 0.0) * velocity;
      motion.velocity = velocity;
      return motion;
    }
    motion.position = state.positions[0][bead] + time * (velocity + 0.5 * ahead * gained);
    motion.velocity = velocity + ahead * gained;
    return motion;
  }

  const OverdampedPlan& plan_;
  std::vector<BeadRange> bead_ranges_;
  OverdampedSystem system_;
};

std::unique_ptr<Model> OverdampedPlan::make() const {
  return std::make_unique<OverdampedModel>(*this);
}

}  // namespace

std::unique_ptr<ModelPlan> overdamped_plan(const Layout& layout, const RunSettings& requested,
                                           const std::string& source, const Communicator& communicator) {
  return std::make_unique<OverdampedPlan>(layout, requested, source, communicator);
}

}  // namespace beadswim
