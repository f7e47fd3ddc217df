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

// Swimmers whose beads have no inertia. The velocity of each bead follows from the present forces on all
// beads:
//
//   dx/dt = v,   v = mu(x) F(x, v, t)
//
//   F  forces by springs, dashpots, angular springs, driving and contacts
//
// A time step is a backward difference formula of third order (BDF3), with linearised forces at its end:
//
//   11/6 x' - 3 x + 3/2 x_1 - 1/3 x_2 = h v',   v' = mu(x*) [ F(x*) - K (x' - x*) - C v' ]
//
//   x'      positions at the end of the step; x, x_1, x_2 positions now and one and two steps ago
//   x*      expansion point: extrapolated from earlier steps, and updated if the step ends far from it
//   K       stiffness of springs, angular springs and contacts
//   C       damping of the dashpots
//   h       time step
//
// The stiff forces of all swimmers are solved for together, so that the time step need not resolve their
// relaxation, even for close swimmers. One product mu F per step suffices where the flow changes smoothly. A
// few more products are evaluated elsewhere (implicit_step.hpp). The first two steps are implicit Euler
// steps, extrapolated to third order.
//
// References: Hairer and Wanner, Solving Ordinary Differential Equations II (Springer 1996), III.1 and IV.9.
// Page: docs/method/mobility-swarms.md.

namespace beadswim {

enum class OverdampedFaultKind {
  not_finite,     ///< a position is non-finite
  speed,          ///< a bead moved by more than its radius in one step; value: displacement [radius]
  torn_arm,       ///< an arm exceeds twice its rest length; value: length [rest length]
  wall,           ///< the centre of a bead is beyond a wall; value: distance [length]
  not_converged,  ///< the solver did not converge; concerns no single bead
};

struct OverdampedFault {
  OverdampedFaultKind kind = OverdampedFaultKind::not_finite;
  long step = 0;                 ///< steps done, the faulty one included
  int swimmer = 0;               ///< id
  int bead = 0;                  ///< number of the bead, 1 to 3, or of the arm, 1 or 2
  Vec3 position = Vec3::Zero();  ///< position of the bead before the step [length]
  double value = 0;              ///< quantity in the unit that the kind states
};

/// State of the beads, from which a run continues, and statistics of the steps done.
struct OverdampedState {
  long steps_done = 0;
  long products = 0;         ///< mobility products evaluated
  double largest_speed = 0;  ///< maximum over beads and steps [length/time]
  double smallest_gap =
      std::numeric_limits<double>::infinity();  ///< between beads that repelled each other [length]
  std::array<Beads, 3> positions;               ///< now, one step ago and two steps ago [length]
  std::array<Beads, 2> velocities;              ///< now and one step ago [length/time]
  std::array<Beads, 3>
      distant;  ///< velocities by all other swimmers; now, one and two steps ago [length/time]

  /// Visits the statistics.
  static void visit_fields(auto&& visit, auto& state) {
    visit("products", state.products);
    visit("largest_speed", state.largest_speed);
    visit("smallest_gap", state.smallest_gap);
  }
  /// Visits the fields that determine all later steps.
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
  /// Places the beads at their rest positions at time 0. Throws InputError as MobilityProduct does.
  /// Collective.
  OverdampedSystem(OverdampedScene scene, const Communicator& communicator);
  ~OverdampedSystem();

  /// Advances by one step. After a fault, beads keep their positions. Collective.
  void step();

  long steps_done() const { return state_.steps_done; }
  double time() const { return static_cast<double>(state_.steps_done) * scene_.step; }
  const OverdampedScene& scene() const { return scene_; }
  const OverdampedState& state() const { return state_; }
  const MobilityProduct& mobility() const { return mobility_; }

  /// One vector per bead, three beads per swimmer, in order of the swimmers.
  std::span<const Vec3> positions() const { return state_.positions[0]; }
  std::span<const Vec3> velocities() const { return state_.velocities[0]; }

  /// Returns the range [first, end) of the swimmers that this rank advances.
  std::pair<std::size_t, std::size_t> own_swimmers() const;

  const std::optional<OverdampedFault>& fault() const { return fault_; }

  /// Continues from a state of the same scene. Throws SolverError if the number of beads differs.
  void restore(OverdampedState state);

 private:
  struct Step {
    Beads displacements, velocities, distant;
  };

  ImplicitStepResult solve_step(const StepRule& rule, const Beads& from, const Beads& guess,
                                const Beads& distant);
  void solve_initial_velocities();
  Step take_euler_steps(int parts);
  void take_first_step();
  void take_bdf_step();
  void accept(Step step);
  void check_faults();

  OverdampedScene scene_;
  const Communicator& communicator_;
  std::vector<double> radii_;  ///< one per bead [length]
  MobilityProduct mobility_;
  std::unique_ptr<ImplicitStep> implicit_step_;
  OverdampedState state_;
  bool is_converged_ = true;  ///< all steps so far converged
  std::optional<OverdampedFault> fault_;
};

}  // namespace beadswim
