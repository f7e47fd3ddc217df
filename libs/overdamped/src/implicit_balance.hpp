#pragma once

#include <span>
#include <vector>

#include "bead_vectors.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/overdamped/contacts.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"
#include "implicit_swimmer.hpp"

namespace beadswim {

/// The scene as a step sees it. All must outlive it.
struct StepScene {
  const OverdampedScene& scene;
  std::span<const double> radii;  ///< of all beads
  const ContactScale& contact_scale;
  const Communicator& communicator;
};

/// The linear system of a step about u* (implicit_step.hpp), each swimmer's part kept by the rank that it is
/// of. Numbers of all beads go in and come out, the same on all ranks; what returns any is collective.
class ImplicitBalance {
 public:
  /// Contacts and forces about `about`, u*. Places `now`, `from` and `about` must outlive it.
  ImplicitBalance(const StepScene& step, const StepRule& rule, const Beads& now, const Beads& from,
                  const Beads& about, const Beads& distant);

  Beads first_ends() const;                                             ///< u if d does not change
  Beads first_forces() const;                                           ///< F if d does not change
  Beads displacements(const Beads& velocities) const;                   ///< u = (r + h v)/w
  Beads residual(const Beads& forces, const Beads& velocities) const;   ///< drive - D v - F
  Beads left_side(const Beads& forces, const Beads& velocities) const;  ///< F + D v
  Beads own_forces(const Beads& residual) const;                        ///< p of (1 + D mu_own) p = residual
  Beads own_velocities(const Beads& forces) const;                      ///< mu_own F
  double smallest_gap(const Beads& velocities) const;                   ///< [length] of contacts at the end

 private:
  template <class Value>
  Beads of_each(const Value& value) const;
  void share(Beads& beads) const;
  Beads beyond_about(const Beads& velocities) const;

  const Communicator& communicator_;
  StepRule rule_;
  const Beads &from_, &about_;
  std::size_t first_ = 0, last_ = 0;  ///< swimmers of this rank
  std::vector<ImplicitSwimmer> parts_;
  std::vector<Contact> within_, between_;  ///< swimmers
};

}  // namespace beadswim
