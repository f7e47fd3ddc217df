#pragma once

#include <limits>
#include <span>

#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/overdamped/contacts.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"
#include "implicit_balance.hpp"

// An implicit step of all swimmers: displacements u with w u - r = h v, velocities v and forces F of
//
//   v = mu F,   F + D v = drive,   mu, D and drive about u*
//
// D has a block for each swimmer (implicit_swimmer.hpp), and contacts between swimmers. Were the flow known
// that carries a swimmer, d = v - mu_own F, each could be solved alone. So they are, by d carried forward
// from steps before: u* is the guess, or, where swimmers alone would end farther from it, where they end
// (Newton's method, contacts sought again each time). One product then tells the residual
//
//   rho = drive - D v - F
//
// which is small where d is smooth. It is answered by each swimmer alone, F += p and v += mu_own p of
// (1 + D mu_own) p = rho, where that is under 0.3 of the product's tolerance, and otherwise reduced by
// generalised conjugate residuals, preconditioned by the same, a product each. Where the step then ends far
// from u*, as beads that meet do, all is done again about that end.
//
// Reference: Eisenstat, Elman and Schultz, SIAM J. Numer. Anal. 20, 345 (1983).

namespace beadswim {

struct ImplicitStepResult {
  Beads displacements;  ///< u
  Beads velocities;     ///< v
  Beads distant;        ///< d
  long products = 0;
  double smallest_gap =
      std::numeric_limits<double>::infinity();  ///< [length] of beads that repel each other at the end
  bool is_solved = true;
};

class ImplicitStep {
 public:
  /// All must outlive it.
  ImplicitStep(const OverdampedScene& scene, std::span<const double> radii, const MobilityProduct& mobility,
               const Communicator& communicator);

  /// `now`: places; `from`: r; `guess`: of u; `distant`: of d. Of all beads, the same on all ranks.
  /// Collective.
  ImplicitStepResult solve(const StepRule& rule, const Beads& now, const Beads& from, const Beads& guess,
                           const Beads& distant) const;

 private:
  ImplicitStepResult solve_about(const ImplicitBalance& balance, const Beads& about, const Beads& now) const;
  double farthest_move(const Beads& from, const Beads& to) const;

  const OverdampedScene& scene_;
  std::span<const double> radii_;
  const MobilityProduct& mobility_;
  const Communicator& communicator_;
  ContactScale contact_scale_;
  double smallest_radius_;
  double shortest_arm_ = std::numeric_limits<double>::infinity();
};

}  // namespace beadswim
