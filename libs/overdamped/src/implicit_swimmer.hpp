#pragma once

#include <Eigen/LU>

#include "beadswim/overdamped/contacts.hpp"
#include "swimmer_response.hpp"

// One swimmer's part of an implicit step. For displacements u over the step, of the rule w u - r = h v, its
// forces are taken at u* and are linear about it,
//
//   F = F(u*) - K (u - u*) - C v = drive - D v,   D = C + h/w K,   drive = F(u*) - K (r/w - u*)
//
// K stiffness of springs, of the angular spring and of contacts among its own beads, C of dashpots. Flow of
// all others carries its beads at velocities d, so that alone it would answer to
//
//   v = mu_own F + d,   (1 + D mu_own) F = drive - D d

namespace beadswim {

/// u of weight u - from = span v, v at its end; displacements from where beads are now.
struct StepRule {
  double weight = 1;  ///< w
  double span = 0;    ///< h [time]; 0: velocities here and now
  double time = 0;    ///< at the end
};

/// What the swimmer meets: all in nine numbers.
struct SwimmerSurroundings {
  const SwimmerType& type;
  Vec3 initial_axis;
  Vector9 now;               ///< places of its beads
  Vector9 from, about;       ///< r, u*
  Vector9 distant;           ///< d
  Vector9 others;            ///< forces by contacts with others at u*
  Matrix9 others_stiffness;  ///< of these: against its own beads' displacements
  double viscosity = 0;      ///< dynamic
  const ContactScale& scale;
};

struct ImplicitSwimmer {
  Vector9 drive;                         ///< without contacts with others
  Matrix9 resistance;                    ///< D, without contacts with others
  Matrix9 mobility;                      ///< mu_own, in open space
  Eigen::PartialPivLU<Matrix9> balance;  ///< of 1 + D mu_own, contacts with others in D
  Vector9 forces;                        ///< F if d does not change
  Vector9 end;                           ///< u if d does not change
};

ImplicitSwimmer implicit_swimmer(const StepRule& rule, const SwimmerSurroundings& surroundings);

}  // namespace beadswim
