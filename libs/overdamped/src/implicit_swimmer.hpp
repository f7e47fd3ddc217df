#pragma once

#include <Eigen/LU>

#include "beadswim/overdamped/contacts.hpp"
#include "beadswim/swimmers/swimmer_matrices.hpp"

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
// In a fluid with memory, F is the force on the fluid. It contains the inertia of the bead beyond that of the
// displaced fluid, -m' dv/dt with h dv/dt = w v - (history of the velocities), which adds m' w/h to D.
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

/// A swimmer and all quantities that act on it. Vectors contain x, y, z of bead 1, of bead 2, ... An external
/// contact is a contact with another swimmer or with an image.
template <int Size>
struct SwimmerSurroundings {
  using Vector = SwimmerVector<Size>;

  const SwimmerType& type;
  const Eigen::Matrix3d& initial_orientation;  ///< orientation at the start of the run
  Vector start;                                ///< positions of the beads at the start of the step [length]
  Vector history, expansion_point;  ///< history r, expansion point u* of the displacements [length]
  Vector distant;                   ///< d, velocities in the flow of all other swimmers [length/time]
  Vector inertia;                   ///< m' w/h, for the force of inertia -m' dv/dt [mass/time]
  Vector inertia_forces;            ///< m' times the history of the velocities, divided by h [force]
  Vector external_forces;           ///< forces of the external contacts at u* [force]
  const Eigen::MatrixXd& external_stiffness;  ///< of the external contacts [mass/time^2]; empty: no contacts
  double viscosity = 0;                       ///< dynamic viscosity eta [mass/(length time)]
  double step_wavenumber = 0;                 ///< kappa of step_mobility.hpp [1/length]; 0: steady flow
  double contact_strength = 0;                ///< strength of the repulsion (ContactScale) [force]
  double own_cutoff_per_radius = 0;  ///< cutoff for two beads of the swimmer, divided by their mean radius
};

/// Linear system (1 + D mu_own) F = drive - D d of a swimmer, and its solution for the given d. An external
/// contact is a contact with another swimmer or with an image.
template <int Size>
struct ImplicitSwimmer {
  static constexpr int size = Size;  ///< number of vector components, or Eigen::Dynamic

  SwimmerVector<Size> drive;       ///< drive without external contacts [force]
  SwimmerMatrix<Size> resistance;  ///< D without external contacts [mass/time]
  SwimmerMatrix<Size> mobility;    ///< mu_own, mobility of the swimmer alone in open space [time/mass]
  Eigen::PartialPivLU<SwimmerMatrix<Size>> balance{};  ///< 1 + D mu_own, where D includes external contacts
  SwimmerVector<Size> forces;                          ///< F, forces on the beads [force]
  SwimmerVector<Size> end;  ///< u, displacements of the beads at the end of the step [length]
};

/// Evaluates the linear system of a swimmer in one time step and solves it, with given velocities d in the
/// flow of all other swimmers.
template <int Size>
ImplicitSwimmer<Size> implicit_swimmer(const StepRule& rule, const SwimmerSurroundings<Size>& surroundings);

}  // namespace beadswim
