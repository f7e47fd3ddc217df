#pragma once

#include <vector>

#include "beadswim/overdamped/overdamped_scene.hpp"

// Independent integrator of swarms without inertia, for comparisons: CVODE of SUNDIALS with backward
// differentiation formulas. Orders (up to five) and step sizes follow from a tolerance. The equation of each
// step is solved by Newton's method. GMRES solves its linear systems with products of the Jacobian, and with
// a 9 x 9 preconditioner for each swimmer:
//
//   (I + gamma mu_own K_own)^-1,   K = -dF/dx of springs and angular springs
//
// References: Cohen and Hindmarsh, Computers in Physics 10, 138 (1996); Hindmarsh et al., ACM Trans. Math.
// Softw. 31, 363 (2005).

namespace beadswim {

enum class CvodeJacobian {
  difference_quotient,  ///< complete Jacobian: [v(x + s z) - v(x)]/s
  springs,              ///< only the springs: -mu K z with constant mobility mu
};

/// Tolerances of CVODE: the local error of a step may be `relative` times the displacement of a coordinate
/// since the start, plus `absolute`.
struct CvodeSettings {
  double relative = 0;
  double absolute = 0;  ///< [length]
  CvodeJacobian jacobian = CvodeJacobian::difference_quotient;
};

struct CvodeResult {
  std::vector<Vec3> positions;  ///< positions of all beads, three per swimmer
  long products = 0;            ///< number of mobility products, with those for the Jacobian
  long steps = 0;
};

/// Returns the bead positions at the time `end` of swimmers that begin at rest length at time 0. Ignores
/// `step` of the scene, dashpots and contacts, so the scene must not have dashpots or contacts. Throws
/// SolverError if CVODE fails. For one rank only.
CvodeResult by_cvode(const OverdampedScene& scene, double end, const CvodeSettings& settings);

}  // namespace beadswim
