#pragma once

#include <span>
#include <vector>

#include "bead_vectors.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/overdamped/contacts.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"
#include "implicit_swimmer.hpp"

namespace beadswim {

/// References to the scene and its communicator, which must outlive this object.
struct StepScene {
  const OverdampedScene& scene;
  std::span<const double> radii;  ///< one per bead [length]
  const ContactScale& contact_scale;
  const Communicator& communicator;
};

/// Linear system of a time step, linearised at the expansion point u*. Symbols as in implicit_step.hpp. Each
/// rank stores the parts of its own swimmers. Arguments and results contain all beads and are equal on all
/// ranks. Functions that return Beads are collective.
class ImplicitBalance {
 public:
  /// Evaluates forces and contacts at the expansion point. `start`: positions x now; `history`: r;
  /// `expansion_point`: u*; `distant`: d. `history` and `expansion_point` must outlive this object.
  ImplicitBalance(const StepScene& step, const StepRule& rule, const Beads& start, const Beads& history,
                  const Beads& expansion_point, const Beads& distant);

  Beads initial_displacements() const;                                       ///< u for the given d
  Beads initial_forces() const;                                              ///< F for the given d
  Beads displacements(const Beads& velocities) const;                        ///< u = (r + h v)/w
  Beads residual(const Beads& forces, const Beads& velocities) const;        ///< drive - D v - F
  Beads left_hand_side(const Beads& forces, const Beads& velocities) const;  ///< F + D v
  Beads own_forces(const Beads& residual) const;    ///< solves (1 + D mu_own) p = residual for p
  Beads own_velocities(const Beads& forces) const;  ///< mu_own F
  /// Returns the smallest gap of all contacts at the end of the step [length].
  double smallest_gap(const Beads& velocities) const;

 private:
  template <class Value>
  Beads gather(const Value& value) const;
  void share(Beads& beads) const;
  Beads displacements_from_expansion(const Beads& velocities) const;

  const Communicator& communicator_;
  StepRule rule_;
  const Beads &history_, &expansion_point_;
  std::size_t first_ = 0, last_ = 0;  ///< this rank has the swimmers [first_, last_)
  std::vector<ImplicitSwimmer> parts_;
  std::vector<Contact> internal_contacts_, external_contacts_;  ///< within a swimmer; all others
};

}  // namespace beadswim
