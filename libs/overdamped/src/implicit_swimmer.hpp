#pragma once

#include <Eigen/LU>
#include <algorithm>

#include "bead_vectors.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/overdamped/contacts.hpp"

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

/// What all time steps of a scene have in common. m' is the mass of a bead minus that of the displaced fluid.
struct StepScene {
  const OverdampedScene& scene;
  std::span<const double> radii;  ///< radius of each bead [length]
  const Communicator& communicator;
  double smallest_radius = std::ranges::min(radii);  ///< [length]
  ContactScale contact_scale{scene};
  std::vector<BeadRange> bead_ranges = beadswim::bead_ranges(scene);  ///< of each swimmer
  /// m' of each bead; empty without memory.
  std::vector<double> excess_masses = beadswim::excess_masses(scene);
  /// rho V: mass of fluid that would fill the box; 0 without memory.
  double fluid_mass = scene.memory ? scene.memory->density * scene.domain.box->lengths.prod() : 0;
};

/// Histories r of a time step (StepRule).
struct StepHistory {
  Beads displacements;  ///< in w u - r = h v [length]
  Beads velocities;     ///< in w v - r = h dv/dt [length/time]; used only with memory of the fluid
};

/// Thermal noise in a time step (thermal_noise.hpp).
struct StepNoise {
  Beads velocities;  ///< w, added to those by forces [length/time]
  /// Displacements from the start of the step at which the mobility is evaluated [length].
  Beads mobility_at;
};

/// A time step. The vectors of all beads are equal on all ranks, and must outlive this object.
struct StepStart {
  const StepRule& rule;
  const Beads& positions;        ///< at the start of the step [length]
  const StepHistory& history;    ///< r
  const Beads& expansion_point;  ///< u*, at first a guess of the displacements u [length]
  const Beads& distant;  ///< d, velocities in the flow of all other swimmers, and by noise [length/time]
  const StepNoise* noise = nullptr;  ///< null: none
  /// Guess of the moments on the fluid at the end of the step (Mobility::moments()); empty: none.
  std::span<const double> moments{};
};

/// Contacts of a swimmer at u*: with itself, and external ones with other swimmers and with images.
struct SwimmerContacts {
  std::span<const Contact> own;               ///< by the numbers of the beads
  const Beads& external_forces;               ///< on all beads [force]
  const Eigen::MatrixXd& external_stiffness;  ///< [mass/time^2]; empty without contacts
};

/// Linear system (1 + D mu_own) F = drive - D d of a swimmer, and its solution for the given d.
template <int Size>
struct ImplicitSwimmer {
  SwimmerVector<Size> drive;       ///< drive without external contacts [force]
  SwimmerMatrix<Size> resistance;  ///< D without external contacts [mass/time]
  SwimmerMatrix<Size> mobility;    ///< mu_own, mobility of the swimmer alone in open space [time/mass]
  Eigen::PartialPivLU<SwimmerMatrix<Size>> balance{};  ///< 1 + D mu_own, where D includes external contacts
  SwimmerVector<Size> forces;                          ///< F, forces on the beads [force]
  SwimmerVector<Size> end;  ///< u, displacements of the beads at the end of the step [length]
};

/// Evaluates the linear system of swimmer `number` in one time step, and solves it for the given d.
template <int Size>
ImplicitSwimmer<Size> implicit_swimmer(const StepScene& scene, const StepStart& step, std::size_t number,
                                       const SwimmerContacts& contacts);

}  // namespace beadswim
