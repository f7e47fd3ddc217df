#pragma once

#include <limits>
#include <span>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/mobility_product.hpp"
#include "beadswim/overdamped/contacts.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"
#include "implicit_swimmer.hpp"

// An implicit step of all swimmers: displacements u with w u - r = h v, velocities v and forces F of
//
//   v = mu F,   F + D v = drive,   mu at u* near u
//
// D has a block for each swimmer (implicit_swimmer.hpp), and contacts between swimmers. Were the flow known
// that carries a swimmer, d = v - mu_own F, each could be solved alone. So they are, by d carried forward
// from steps before; one product then tells the residual
//
//   rho = drive - D v - F
//
// which is small where d is smooth. It is answered by each swimmer alone, F += p and v += mu_own p of
// (1 + D mu_own) p = rho, where that is under 0.3 of the product's tolerance, and otherwise reduced by
// generalised conjugate residuals, preconditioned by the same, a product each.
//
// Reference: Eisenstat, Elman and Schultz, SIAM J. Numer. Anal. 20, 345 (1983).

namespace beadswim {

using Beads = std::vector<Vec3>;

struct ImplicitStepResult {
  Beads displacements;  ///< u
  Beads velocities;     ///< v
  Beads distant;        ///< d
  long products = 0;
  double smallest_gap = std::numeric_limits<double>::infinity();  ///< of beads that repel each other
  double unsolved = 0;  ///< velocities by the residual over all, where too many products did not do
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
  class Balance;

  const OverdampedScene& scene_;
  std::span<const double> radii_;
  const MobilityProduct& mobility_;
  const Communicator& communicator_;
  ContactScale contact_scale_;
};

}  // namespace beadswim
