#pragma once

#include <limits>
#include <span>

#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/overdamped/contacts.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"
#include "implicit_balance.hpp"

// An implicit time step of all swimmers. Displacements u with w u - r = h v, velocities v and forces F solve
//
//   v = mu F,   F + D v = drive
//
// where mu, D and drive are evaluated at the expansion point u*. D has one dense block per swimmer
// (implicit_swimmer.hpp) and sparse entries for contacts between swimmers.
//
// If the flow d = v - mu_own F caused by all other swimmers were known, each swimmer could be solved alone.
// This gives the first approximation, with d extrapolated from earlier steps. u* is the initial guess. If
// swimmers solved alone end too far from it, u* is moved to their end and the contacts are found again
// (Newton's method).
//
// One mobility product then gives the residual
//
//   rho = drive - D v - F
//
// which is small where d varies smoothly. The correction of each swimmer alone is F += p and v += mu_own p
// with (1 + D mu_own) p = rho. If it is below 0.3 of the tolerance of the product, it is applied and the step
// ends. Otherwise the residual is reduced by the generalised conjugate residual method (GCR), with this
// correction as preconditioner and one product per iteration. If the step then ends far from u*, for example
// where beads come into contact, the solution is repeated with u* at that end.
//
// Reference: Eisenstat, Elman and Schultz, SIAM J. Numer. Anal. 20, 345 (1983).

namespace beadswim {

struct ImplicitStepResult {
  Beads displacements;  ///< u
  Beads velocities;     ///< v
  Beads distant;        ///< d
  long products = 0;    ///< mobility products evaluated
  double smallest_gap =
      std::numeric_limits<double>::infinity();  ///< between beads that repel each other at the end [length]
  bool is_converged = true;
};

class ImplicitStep {
 public:
  /// Keeps references to all arguments.
  ImplicitStep(const OverdampedScene& scene, std::span<const double> radii, const MobilityProduct& mobility,
               const Communicator& communicator);

  /// Solves one step. `start`: positions now; `from`: r; `guess`: of u; `distant`: extrapolated d. Arrays
  /// hold all beads and are equal on all ranks. Collective.
  ImplicitStepResult solve(const StepRule& rule, const Beads& start, const Beads& from, const Beads& guess,
                           const Beads& distant) const;

 private:
  ImplicitStepResult solve_linearised(const ImplicitBalance& balance, const Beads& expansion_point,
                                      const Beads& start) const;
  double largest_move(const Beads& from, const Beads& to) const;

  const OverdampedScene& scene_;
  std::span<const double> radii_;
  const MobilityProduct& mobility_;
  const Communicator& communicator_;
  ContactScale contact_scale_;
  double smallest_radius_;                                         ///< [length]
  double shortest_arm_ = std::numeric_limits<double>::infinity();  ///< smallest rest length [length]
};

}  // namespace beadswim
