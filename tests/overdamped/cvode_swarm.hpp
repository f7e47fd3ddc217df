#pragma once

#include <vector>

#include "beadswim/overdamped/overdamped_scene.hpp"

// An independent integrator of swarms without inertia: backward differences of any order up to five with
// steps and orders that follow from a tolerance, by CVODE of SUNDIALS. Each step's equation is solved by
// Newton's method, its linear systems by GMRES, that needs products of the Jacobian alone, preconditioned for
// each swimmer with nine by nine numbers,
//
//   (I + gamma mu_own K_own)^-1,   K = -dF/dx of springs and angular springs
//
// References: Cohen and Hindmarsh, Computers in Physics 10, 138 (1996); Hindmarsh et al., ACM Trans. Math.
// Softw. 31, 363 (2005).

namespace beadswim {

enum class CvodeJacobian {
  difference_quotient,  ///< [v(x + s z) - v(x)]/s, all of it
  springs,              ///< -mu K z: mobility held
};

/// A step's local error may be `relative` of how far a coordinate has come, and `absolute`.
struct CvodeSettings {
  double relative = 0;
  double absolute = 0;  ///< [length]
  CvodeJacobian jacobian = CvodeJacobian::difference_quotient;
};

struct CvodeResult {
  std::vector<Vec3> positions;  ///< of all beads, three a swimmer
  long products = 0;            ///< of mobility and forces, those in products of the Jacobian too
  long steps = 0;
};

/// Where beads are that were at rest positions at time 0. Of the scene all but `step` is taken; without
/// dashpots, and without contacts: the scene is to have none. Throws SolverError if CVODE gives up. On one
/// rank.
CvodeResult by_cvode(const OverdampedScene& scene, double end, const CvodeSettings& settings);

}  // namespace beadswim
