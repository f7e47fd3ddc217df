#pragma once

#include <variant>
#include <vector>

#include "implicit_swimmer.hpp"

namespace beadswim {

/// Linear system of a time step, F + D v = drive and v = mu F, linearised at the expansion point u*
/// (implicit_step.hpp). u: displacements of the beads in the step; v, F: velocities and forces at its end;
/// mu, D: mobility and resistance; d: velocities in the flow of other swimmers. Each rank stores the parts of
/// its own swimmers. Arguments and results contain all beads and are equal on all ranks. Functions that
/// return Beads are collective.
class ImplicitBalance {
 public:
  /// Evaluates forces and contacts at the expansion point. The arguments must outlive this object.
  ImplicitBalance(const StepScene& scene, const StepStart& step);

  /// Return u and F if each swimmer is solved alone, in the flow d passed to the constructor.
  Beads initial_displacements() const;
  Beads initial_forces() const;
  /// Returns the displacements u = (r + h v)/w for the velocities v at the end of the step.
  Beads displacements(const Beads& velocities) const;
  /// Returns the residual drive - D v - F of the force balance.
  Beads residual(const Beads& forces, const Beads& velocities) const;
  /// Returns the left-hand side F + D v of the force balance.
  Beads left_hand_side(const Beads& forces, const Beads& velocities) const;
  /// Returns the solution p of (1 + D mu_own) p = residual. mu_own: mobility of each swimmer alone.
  Beads own_forces(const Beads& residual) const;
  /// Returns mu_own F, the velocities that forces F cause if each swimmer is alone.
  Beads own_velocities(const Beads& forces) const;
  /// Returns the smallest gap of all contacts at the end of a step with these velocities [length].
  double smallest_gap(const Beads& velocities) const;

 private:
  using Part = std::variant<ImplicitSwimmer<size_of_three_beads>, ImplicitSwimmer<Eigen::Dynamic>>;

  template <class Value>
  Beads gather(const Value& value) const;
  void share(Beads& beads) const;
  Beads displacements_from_expansion(const Beads& velocities) const;

  const StepScene& scene_;
  StepStart step_;
  std::size_t first_ = 0, last_ = 0;  ///< this rank has the swimmers [first_, last_)
  std::vector<Part> parts_;
  std::vector<Contact> own_contacts_, external_contacts_;  ///< between beads of one swimmer; all others
};

}  // namespace beadswim
