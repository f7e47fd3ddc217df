#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "beadswim/mobility/mobility_root.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"
#include "beadswim/scene/fault.hpp"

// Swimmers in a fluid without inertia, or with memory (mobility/fluid_memory.hpp). Without inertia, the
// velocities v of the beads depend on the present positions x of all beads and on the present forces F:
//
//   dx/dt = v,   v = mu(x) F(x, v, t)
//
//   F   forces of springs, dashpots, angular springs, driving and contacts
//   mu  mobility of all beads (mobility.hpp)
//
// A time step uses the backward difference formula of third order (BDF3). The forces are linearised at the
// end of the step:
//
//   11/6 x' - 3 x + 3/2 x_1 - 1/3 x_2 = h v',   v' = mu(x*) [ F(x*) - K (x' - x*) - C v' ]
//
//   x', v'  positions and velocities at the end of the step
//   x       positions now;  x_1, x_2  positions one step and two steps ago
//   x*      expansion point: extrapolated from earlier steps, and updated if the step ends far from it
//   K       stiffness of springs, angular springs and contacts
//   C       damping of the dashpots
//   h       time step
//
// With memory of the fluid, mu is the mobility in a step, v' contains the flow that earlier forces have left,
// and F the inertia of the beads beyond that of the displaced fluid. All begins at rest.
//
// The forces at the end of the step are solved for all swimmers together. The time step may therefore exceed
// the relaxation times of the springs, even if swimmers are close. One product mu F per step suffices if the
// flow changes smoothly. Otherwise a step evaluates a few more products (implicit_step.hpp). Each of the
// first two steps is extrapolated to third order from implicit Euler steps; with memory, earlier positions
// are those at rest. With thermal noise, each step is one of the implicit midpoint rule (thermal_noise.hpp).
//
// References: Hairer and Wanner, Solving Ordinary Differential Equations II (Springer 1996), III.1 and IV.9.
// Page: docs/method/mobility-swarms.md.

namespace beadswim {

/// State from which a run continues, and statistics of all steps so far.
struct OverdampedState {
  long steps_done = 0;
  ProductWork work;  ///< of all mobility products so far
  /// Largest speed of any bead in any step, relative to the background flow [length/time].
  double largest_speed = 0;
  /// Smallest gap of any contact in any step [length]; infinity without contacts.
  double smallest_gap = std::numeric_limits<double>::infinity();
  /// Smallest height of a bead over the wall, relative to the radius of the bead, in any step; infinity
  /// without half-space.
  double smallest_relative_height = std::numeric_limits<double>::infinity();
  /// Number of steps, smallest gap [radius of the smallest bead] and relative height at the last check of the
  /// mobility of oseen.
  long checked_steps = 0;
  double checked_gap = 0, checked_height = 0;
  std::array<Beads, 3> positions;   ///< positions now, one step ago and two steps ago [length]
  std::array<Beads, 3> velocities;  ///< velocities now, one step ago and two steps ago [length/time]
  /// Part of the velocities of the beads that is due to the flow of all other swimmers: now, and one to five
  /// steps ago [length/time].
  std::array<Beads, 6> distant;
  /// Moments that the beads exert on the fluid now, and one to five steps ago, if they are found by iteration
  /// and there is no noise; otherwise empty.
  std::array<std::vector<double>, 6> moments;
  /// Eigenvector of the smallest eigenvalue of the mobility of oseen at its last check; other models: empty.
  Beads lowest_mode;
  /// With thermal noise: velocities in the last step without those of the noise; otherwise empty.
  Beads smooth;
  double noise_error = 0;  ///< largest relative error of the noise in any step

  /// Visits the statistics.
  static void visit_fields(auto&& visit, auto& state) {
    visit("products", state.work.products);
    visit("iterations", state.work.iterations);
    visit("residual", state.work.residual);
    visit("largest_speed", state.largest_speed);
    visit("smallest_gap", state.smallest_gap);
    visit("smallest_relative_height", state.smallest_relative_height);
    visit("checked_steps", state.checked_steps);
    visit("checked_gap", state.checked_gap);
    visit("checked_height", state.checked_height);
    visit("noise_error", state.noise_error);
  }
  /// Visits the vectors per bead that determine all later steps.
  static void visit_bead_fields(auto&& visit, auto& state) {
    visit("positions", state.positions);
    visit("velocities", state.velocities);
    visit("distant", state.distant);
    visit("moments", state.moments);
    visit("lowest_mode", state.lowest_mode);
    visit("smooth", state.smooth);
  }
};

struct ImplicitStepResult;
struct StepNoise;
struct StepHistory;
struct StepRule;
struct StepScene;

class OverdampedSystem {
 public:
  /// Places the beads at their rest positions at time 0. Throws InputError if the scene is invalid for the
  /// mobility product, for example if a radius is, or if the mobility is not positive definite. Collective.
  OverdampedSystem(OverdampedScene scene, const Communicator& communicator);
  ~OverdampedSystem();

  /// Advances the swimmers by one time step. After a fault, only steps_done() increases. Collective.
  void step();

  long steps_done() const { return state_.steps_done; }
  double time() const { return static_cast<double>(state_.steps_done) * scene_.step; }
  const OverdampedScene& scene() const { return scene_; }
  const OverdampedState& state() const { return state_; }
  const Mobility& mobility() const { return mobility_; }

  /// Returns the mean velocity of fluid and beads, where beads count with the mass of the displaced fluid; 0
  /// without memory of the fluid.
  Vec3 mean_flow() const;
  /// Returns the momentum of fluid and beads [mass length/time]; 0 without memory of the fluid.
  Vec3 momentum() const;

  /// Return positions [length] and velocities [length/time]: one vector per bead, in order of the
  /// swimmers.
  std::span<const Vec3> positions() const { return state_.positions[0]; }
  std::span<const Vec3> velocities() const { return state_.velocities[0]; }

  /// Returns the moments that the beads exert on the fluid (Mobility::moments()) at the end of the last step;
  /// empty at a restart.
  std::span<const double> moments() const { return moments_; }
  /// Returns the flow at points [length] (Mobility::flow_at()). Not at a restart. Collective.
  FlowAtPoints flow_at(std::span<const Vec3> points) {
    return mobility_.flow_at(points, {positions(), velocities(), moments()});
  }

  /// Returns the forces of the fluid on the beads at the end of the last step; empty at a restart. With
  /// memory of the fluid they include the inertia of the fluid that the beads displace, whose acceleration is
  /// known to second order in the time step.
  std::vector<Vec3> fluid_forces() const;

  /// Returns the range [first, end) of the swimmers that this rank advances.
  std::pair<std::size_t, std::size_t> own_swimmers() const;

  const std::optional<Fault>& fault() const { return fault_; }

  /// Replaces the state by a state of the same scene, for example from a checkpoint, and the memory of the
  /// fluid, if there is one, by `memory` (Mobility::restore_memory()). Throws SolverError if the number of
  /// beads or the size of the memory is different. Collective.
  void restore(OverdampedState state, std::span<const double> memory);

 private:
  ImplicitStepResult solve_step(const StepRule& rule, const StepHistory& history, const Beads& guess,
                                const Beads& distant, const StepNoise* noise = nullptr,
                                std::span<const double> moments = {});
  void add_work(const ProductWork& work);
  void solve_initial_velocities();
  bool moves_far(const Beads& from, const Beads& to) const;
  ImplicitStepResult take_euler_steps(int parts);
  template <class Value>
  std::vector<Value> extrapolated(const std::array<std::vector<Value>, 6>& past) const;
  void take_first_step();
  void take_bdf_step();
  void take_noisy_step();
  void accept(ImplicitStepResult step);
  void update_extremes();
  void check_faults();
  std::optional<Fault> mobility_fault();
  bool must_check_mobility() const;

  OverdampedScene scene_;
  const Communicator& communicator_;
  std::vector<double> radii_;  ///< radius of each bead [length]
  Mobility mobility_;
  std::unique_ptr<MobilityRoot> mobility_root_;  ///< null without thermal noise
  std::unique_ptr<const StepScene> step_scene_;
  OverdampedState state_;
  Beads forces_;  ///< of the beads on the fluid at the end of the last step; empty after restore()
  std::vector<double> moments_;
  bool is_converged_ = true;  ///< true if all steps so far converged
  std::optional<Fault> fault_;
};

}  // namespace beadswim
