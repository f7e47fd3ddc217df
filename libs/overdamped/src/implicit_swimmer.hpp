#pragma once

#include <Eigen/LU>

#include "beadswim/overdamped/contacts.hpp"
#include "swimmer_response.hpp"

// One swimmer in an implicit time step with the rule w u - r = h v for its displacements u. The forces are
// linearised at the expansion point u*:
//
//   F = F(u*) - K (u - u*) - C v = drive - D v,   D = C + h/w K,   drive = F(u*) - K (r/w - u*)
//
//   K  stiffness of springs, angular spring and contacts between its own beads [mass/time^2]
//   C  damping of the dashpots [mass/time]
//   d  velocities of its beads in the flow caused by all other swimmers [length/time]
//
// For given d the swimmer satisfies
//
//   v = mu_own F + d,   (1 + D mu_own) F = drive - D d

namespace beadswim {

/// Time discretisation weight u - history = span v, with v at the end of the step. u is the displacement from
/// the positions at the start.
struct StepRule {
  double weight = 1;  ///< w
  double span = 0;    ///< h [time]; 0: velocities at the present positions
  double time = 0;    ///< time at the end of the step [time]
};

/// A swimmer with all quantities that act on it. Vectors hold x, y, z of beads 1, 2, 3.
struct SwimmerSurroundings {
  const SwimmerType& type;
  Vec3 initial_axis;                 ///< axis at the start of the run
  Vector9 start;                     ///< positions of its beads [length]
  Vector9 history, expansion_point;  ///< r, u* [length]
  Vector9 distant;                   ///< d [length/time]
  Vector9 external_forces;           ///< forces by external contacts at u*
  Matrix9 external_stiffness;        ///< stiffness of the external contacts
  double viscosity = 0;              ///< dynamic
  const ContactScale& scale;
};

/// The linear system of a swimmer and its solution. External contacts are those with other swimmers or with
/// images.
struct ImplicitSwimmer {
  Vector9 drive;                         ///< without external contacts
  Matrix9 resistance;                    ///< D, without external contacts
  Matrix9 mobility;                      ///< mu_own, in open space
  Eigen::PartialPivLU<Matrix9> balance;  ///< 1 + D mu_own, where D includes external contacts
  Vector9 forces;                        ///< F for unchanged d
  Vector9 end;                           ///< u for unchanged d
};

/// Evaluates the system of a swimmer and solves it for unchanged d.
ImplicitSwimmer implicit_swimmer(const StepRule& rule, const SwimmerSurroundings& surroundings);

}  // namespace beadswim
