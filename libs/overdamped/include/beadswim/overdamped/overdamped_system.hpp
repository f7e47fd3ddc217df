#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"

// Swimmers whose beads have no inertia: each moves at once as the forces on all beads have it,
//
//   dx/dt = v,   v = mu(x) F(x, v, t),   F of springs, dashpots, angular springs, driving and contacts
//
// Steps are backward differences of third order, of which forces are taken at the step's end,
//
//   11/6 x' - 3 x + 3/2 x_1 - 1/3 x_2 = h v',   v' = mu(x*) [ F(x*) - K (x' - x*) - C v' ]
//
// x* is carried forward from the steps before, and is found anew where a step ends far from it. K is the
// stiffness of springs, angular springs and contacts, C that of dashpots: what is stiff is solved for, of all
// swimmers together, so that steps need not resolve it however near they are. A product mu F a step suffices
// where flow changes smoothly, and a few more are taken where it does not (implicit_step.hpp). Two steps of
// Euler's, extrapolated to third order, begin.
//
// References: Hairer and Wanner, Solving Ordinary Differential Equations II (Springer 1996), III.1 and IV.9.
// Page: docs/method/mobility-swarms.md.

namespace beadswim {

enum class OverdampedFaultKind {
  not_finite,  ///< no number any more
  speed,       ///< a bead moved by more than its radius in a step [radius]
  torn_arm,    ///< an arm over twice its rest length [rest length]
  wall,        ///< the centre of a bead beyond a wall [length]
  unsolved,    ///< velocities and forces that go together were not found; of no one bead
};

struct OverdampedFault {
  OverdampedFaultKind kind = OverdampedFaultKind::not_finite;
  long step = 0;
  int swimmer = 0;  ///< its id
  int bead = 0;     ///< 1 to 3, or the arm, 1 or 2
  Vec3 position = Vec3::Zero();
  double value = 0;  ///< as the kind says
};

/// All that the future depends on, and what is told of the past.
struct OverdampedState {
  long steps_done = 0;
  long products = 0;
  double largest_speed = 0;
  double smallest_gap = std::numeric_limits<double>::infinity();  ///< of beads that repelled each other
  std::array<Beads, 3> positions;   ///< of all beads, now and one and two steps ago
  std::array<Beads, 2> velocities;  ///< now and a step ago
  std::array<Beads, 3> distant;     ///< velocities by all but the own swimmer, as positions

  /// Visits what is told of the past.
  static void visit_fields(auto&& visit, auto& state) {
    visit("products", state.products);
    visit("largest_speed", state.largest_speed);
    visit("smallest_gap", state.smallest_gap);
  }
  /// Visits what the future depends on.
  static void visit_bead_fields(auto&& visit, auto& state) {
    visit("positions", state.positions);
    visit("velocities", state.velocities);
    visit("distant", state.distant);
  }
};

class ImplicitStep;
struct ImplicitStepResult;
struct StepRule;

class OverdampedSystem {
 public:
  /// Beads at rest positions at time 0. Throws InputError as MobilityProduct does. Collective.
  OverdampedSystem(OverdampedScene scene, const Communicator& communicator);
  ~OverdampedSystem();

  /// Advances by one step; after a fault beads stay where they are. Collective.
  void step();

  long steps_done() const { return state_.steps_done; }
  double time() const { return static_cast<double>(state_.steps_done) * scene_.step; }
  const OverdampedScene& scene() const { return scene_; }
  const OverdampedState& state() const { return state_; }
  const MobilityProduct& mobility() const { return mobility_; }

  /// Of all beads, three a swimmer, in order of the swimmers.
  std::span<const Vec3> positions() const { return state_.positions[0]; }
  std::span<const Vec3> velocities() const { return state_.velocities[0]; }

  /// First and end of the swimmers that this rank moves.
  std::pair<std::size_t, std::size_t> own_swimmers() const;

  const std::optional<OverdampedFault>& fault() const { return fault_; }

  /// Goes on from a state of the same scene. Throws SolverError if it is of another number of beads.
  void restore(OverdampedState state);

 private:
  struct Step {
    Beads displacements, velocities, distant;
  };

  ImplicitStepResult solved(const StepRule& rule, const Beads& from, const Beads& guess,
                            const Beads& distant);
  void find_velocities();
  Step euler(int parts);
  void first_step();
  void multistep();
  void accept(Step step);
  void look_for_faults();

  OverdampedScene scene_;
  const Communicator& communicator_;
  std::vector<double> radii_;  ///< of all beads
  MobilityProduct mobility_;
  std::unique_ptr<ImplicitStep> implicit_step_;
  OverdampedState state_;
  bool is_solved_ = true;  ///< by all steps so far
  std::optional<OverdampedFault> fault_;
};

}  // namespace beadswim
