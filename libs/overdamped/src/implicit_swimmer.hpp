#pragma once

#include <Eigen/LU>

#include "beadswim/overdamped/contacts.hpp"
#include "swimmer_response.hpp"

// One swimmer in an implicit time step. v are the velocities of its beads at the end of the step. u are their
// displacements from the start of the step, with w u - r = h v (StepRule). The forces F are linearised at the
// expansion point u*:
//
//   F = F(u*) - K (u - u*) - C v = drive - D v,   D = C + h/w K,   drive = F(u*) - K (r/w - u*)
//
//   K  stiffness of springs, angular spring and contacts between beads of the swimmer [mass/time^2]
//   C  damping of the dashpots [mass/time]
//   d  velocities of the beads in the flow caused by all other swimmers [length/time]
//
// With the mobility mu_own of the swimmer alone, v and F satisfy for given d
//
//   v = mu_own F + d,   (1 + D mu_own) F = drive - D d

namespace beadswim {

/// Time discretisation w u - r = h v. v are the velocities at the end of the step, u the displacements from
/// the start of the step. The history r is a weighted sum of earlier displacements.
struct StepRule {
  double weight = 1;  ///< w, weight of the displacement
  double span = 0;    ///< h, length of the step [time]; 0: evaluates the velocities at the present positions
  double time = 0;    ///< time at the end of the step [time]
};

/// A swimmer and all quantities that act on it. Vectors contain x, y, z of beads 1, 2, 3. An external contact
/// is a contact with another swimmer or with an image.
struct SwimmerSurroundings {
  const SwimmerType& type;
  Vec3 initial_axis;                 ///< axis at the start of the run
  Vector9 start;                     ///< positions of the beads at the start of the step [length]
  Vector9 history, expansion_point;  ///< history r, expansion point u* of the displacements [length]
  Vector9 distant;                   ///< d, velocities in the flow of all other swimmers [length/time]
  Vector9 external_forces;           ///< forces of the external contacts at u* [force]
  Matrix9 external_stiffness;        ///< stiffness of the external contacts [mass/time^2]
  double viscosity = 0;              ///< dynamic viscosity eta [mass/(length time)]
  const ContactScale& scale;
};

/// Linear system (1 + D mu_own) F = drive - D d of a swimmer, and its solution for the given d. An external
/// contact is a contact with another swimmer or with an image.
struct ImplicitSwimmer {
  Vector9 drive;                         ///< drive without external contacts [force]
  Matrix9 resistance;                    ///< D without external contacts [mass/time]
  Matrix9 mobility;                      ///< mu_own, mobility of the swimmer in open space [time/mass]
  Eigen::PartialPivLU<Matrix9> balance;  ///< 1 + D mu_own, where D includes external contacts
  Vector9 forces;                        ///< F, forces on the beads [force]
  Vector9 end;                           ///< u, displacements of the beads at the end of the step [length]
};

/// Evaluates the linear system of a swimmer in one time step and solves it, with given velocities d in the
/// flow of all other swimmers.
ImplicitSwimmer implicit_swimmer(const StepRule& rule, const SwimmerSurroundings& surroundings);

}  // namespace beadswim
