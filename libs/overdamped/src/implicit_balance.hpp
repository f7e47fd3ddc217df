#pragma once

#include <span>
#include <vector>

#include "bead_vectors.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/overdamped/contacts.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"
#include "implicit_swimmer.hpp"

namespace beadswim {

/// References to the scene, which must outlive it.
struct StepScene {
  const OverdampedScene& scene;
  std::span<const double> radii;  ///< one per bead [length]
  const ContactScale& contact_scale;
  const Communicator& communicator;
};

/// Linear system of a time step at the expansion point u* (implicit_step.hpp). Each rank stores the parts of
/// its own swimmers. Arguments and results hold all beads and are equal on all ranks. Functions that return
/// Beads are collective.
class ImplicitBalance {
 public:
  /// Evaluates forces and contacts at `expansion_point`, u*. `history` and `expansion_point` must outlive
  /// this object.
  ImplicitBalance(const StepScene& step, const StepRule& rule, const Beads& start, const Beads& history,
                  const Beads& expansion_point, const Beads& distant);

  Beads initial_displacements() const;                                       ///< u for unchanged d
  Beads initial_forces() const;                                              ///< F for unchanged d
  Beads displacements(const Beads& velocities) const;                        ///< u = (r + h v)/w
  Beads residual(const Beads& forces, const Beads& velocities) const;        ///< drive - D v - F
  Beads left_hand_side(const Beads& forces, const Beads& velocities) const;  ///< F + D v
  Beads own_forces(const Beads& residual) const;    ///< solves (1 + D mu_own) p = residual for p
  Beads own_velocities(const Beads& forces) const;  ///< mu_own F
  double smallest_gap(
      const Beads& velocities) const;  ///< smallest gap of a contact at the end of the step [length]

 private:
  template <class Value>
  Beads gather(const Value& value) const;
  void share(Beads& beads) const;
  Beads displacements_from_expansion(const Beads& velocities) const;

  const Communicator& communicator_;
  StepRule rule_;
  const Beads &history_, &expansion_point_;
  std::size_t first_ = 0, last_ = 0;  ///< swimmers of this rank
  std::vector<ImplicitSwimmer> parts_;
  std::vector<Contact> internal_contacts_, external_contacts_;  ///< within one swimmer; all others
};

}  // namespace beadswim
