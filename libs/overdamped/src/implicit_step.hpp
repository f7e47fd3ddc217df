#pragma once

#include <limits>

#include "beadswim/mobility/mobility.hpp"
#include "implicit_balance.hpp"

// An implicit time step of all swimmers. The unknowns are the displacements u of the beads from the start of
// the step, their velocities v and the forces F at its end. u follows from w u - r = h v, where the weight w,
// the history r and the time step h are given by the time discretisation (StepRule). v and F satisfy
//
//   v = mu F,   F + D v = drive
//
// Here mu is the mobility of all beads. mu, D and drive are evaluated at an expansion point u*. D contains
// the damping of dashpots, and the stiffness of springs, angular springs and contacts. It has one dense block
// per swimmer (implicit_swimmer.hpp) and sparse entries for contacts between swimmers.
//
// The flow d = v - mu_own F is caused by all other swimmers, where mu_own is the mobility of each swimmer
// alone. If d were known, each swimmer could be solved alone. This gives the first approximation, with d
// extrapolated from earlier steps. u* is the initial guess of u. If this approximation is too far from u*, it
// becomes the new u*, and the contacts are found again (Newton's method).
//
// One mobility product then gives the residual
//
//   rho = drive - D v - F
//
// The residual is small if d changes smoothly in time. Each swimmer alone is then corrected by F += p and
// v += mu_own p, where p solves (1 + D mu_own) p = rho. If the norm of mu_own p, divided by the norm of v, is
// below 0.3 of the tolerance of the product, the step is complete after this correction. Otherwise the
// generalised conjugate residual method (GCR) reduces the residual. Its preconditioner is this correction,
// and each iteration evaluates one product. If the resulting u is far from u*, for example when beads come
// into contact, the solution is repeated with this u as u*.
//
// Reference: Eisenstat, Elman and Schultz, SIAM J. Numer. Anal. 20, 345 (1983).

namespace beadswim {

struct ImplicitStepResult {
  Beads displacements{};  ///< u, displacements of the beads in the step
  Beads velocities{};     ///< v, velocities of the beads at the end of the step
  Beads forces{};         ///< F, forces of the beads on the fluid at the end of the step
  /// Moments that the beads exert on the fluid (Mobility::moments()) at the end of the step, up to the
  /// residual.
  std::vector<double> moments{};
  Beads distant{};        ///< d, velocities of the beads in the flow of all other swimmers
  ProductWork work{};     ///< of all mobility products evaluated
  /// Smallest gap of all contacts at the end of the step [length]; infinity without contacts.
  double smallest_gap = std::numeric_limits<double>::infinity();
  bool is_converged = true;
};

/// Solves one step, with the flow d of all other swimmers as extrapolated from earlier steps. The mobility is
/// then at the last expansion point. Collective.
ImplicitStepResult solve_implicit_step(const StepScene& scene, Mobility& mobility, const StepStart& step);

/// Returns the sum of m' v over all beads, without the fluid that they displace.
Vec3 excess_momentum(const StepScene& scene, const Beads& velocities);

/// Returns the mean velocity u_0 of the fluid with the insides of the beads; 0 without memory of the fluid.
/// Fluid and beads together have no momentum. With the volume V of the box:
///
///   rho V u_0 + sum m' v = 0
Vec3 mean_flow(const StepScene& scene, const Beads& velocities);

}  // namespace beadswim
