#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "beadswim/overdamped/contacts.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"

// Swimmers whose beads have no inertia: each moves at once as the forces on all beads have it,
//
//   dx/dt = v,   v = mu(x) F(x, v, t),   F of springs, dashpots, angular springs, driving and contacts
//
// Steps are those of the third-order semi-implicit backward differences: what a swimmer's own springs, and
// contacts among its own beads, do to its own beads, g(x) = 1.3 mu_own F_own, is solved for, all else is
// carried forward from three steps, and one product mu F is taken a step:
//
//   11/6 x' - h g(x') = 3 x - 3/2 x_1 + 1/3 x_2 + h [ 3 (v - g(x)) - 3 (v_1 - g(x_1)) + (v_2 - g(x_2)) ]
//
// At any stiffness that is stable as long as all swimmers together answer 0.65 to 1.5 times as much to their
// springs as each alone. Swarms denser than the paper's ask for more steps a cycle (the page has a table).
// Contacts with others' beads enter g linearly. Two steps of deferred corrections begin. Dashpots are solved
// for together with the velocity, by a few products more.
//
// References: Ascher, Ruuth and Wetton, SIAM J. Numer. Anal. 32, 797 (1995); Dutt, Greengard and Rokhlin, BIT
// 40, 241 (2000). Page: docs/method/mobility-swarms.md.

namespace beadswim {

enum class OverdampedFaultKind {
  not_finite,  ///< no number any more
  speed,       ///< a bead moved by more than its radius in a step [radius]
  torn_arm,    ///< an arm over twice its rest length [rest length]
  wall,        ///< the centre of a bead beyond a wall [length]
  dashpots,    ///< velocities that dashpots hang on were not found; of no one bead [relative change]
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
  std::array<std::vector<Vec3>, 3> positions, velocities;  ///< of all beads, now and one and two steps ago
  std::vector<Vec3> distant;  ///< velocities by all but the own swimmer; where there are dashpots
};

class OverdampedSystem {
 public:
  /// Beads at rest positions at time 0. Throws InputError as MobilityProduct does. Collective.
  OverdampedSystem(OverdampedScene scene, const Communicator& communicator);

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

  /// Goes on from a state of the same scene.
  void restore(OverdampedState state);

 private:
  using Beads = std::vector<Vec3>;

  struct Implicit;
  Contacts contacts_of(const Beads& positions) const;
  Beads forces(const Beads& positions, double time, const Contacts& contacts) const;
  Beads velocities_at(const Beads& positions, double time, const Contacts& contacts);
  Beads velocities_with_dashpots(const Beads& positions, const Beads& forces);
  Implicit implicit_part() const;
  Beads multistep();
  Beads deferred_corrections();
  void share(Beads& positions) const;
  void look_for_faults(const Beads& before);
  void note_extremes();

  OverdampedScene scene_;
  const Communicator& communicator_;
  std::vector<double> radii_;  ///< of all beads
  bool has_dashpots_ = false;
  ContactScale contact_scale_;
  MobilityProduct mobility_;
  OverdampedState state_;
  Contacts contacts_;  ///< of the positions now
  std::optional<OverdampedFault> fault_;
};

}  // namespace beadswim
