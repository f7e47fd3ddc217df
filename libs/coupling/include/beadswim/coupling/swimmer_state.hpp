#pragma once

#include <array>
#include <vector>

#include "beadswim/core/fields.hpp"
#include "beadswim/core/message.hpp"
#include "beadswim/coupling/bead_on_lattice.hpp"
#include "beadswim/swimmers/force_dipole.hpp"
#include "beadswim/swimmers/swimmer_dynamics.hpp"

namespace beadswim {

/// State of one swimmer, kept by the rank that owns it, in lattice units.
struct SwimmerState {
  int id = 0;
  int type = 0;  ///< index into CoupledScene::types
  /// Columns of the orientation at the start of the run (swimmers/swimmer_shape.hpp).
  std::array<Vec3, 3> initial_orientation{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  /// Sum over all steps of the force dipole by the impulses of the fluid, about the mean bead position.
  SymmetricTensor dipole_sum{};
  // One entry per bead:
  SwimmerMotion motion;
  /// Excess mass (density - 1) of fluid that each bead has covered and not yet returned through its links.
  std::vector<double> held_mass;
  /// Fluid mass that each link of a bead returns in the next step, divided by the weight of the link.
  std::vector<double> mass_source;
  SwimmerLoads last_impulse;             ///< impulses of the fluid on the beads in the previous step
  std::vector<Vec3> fluid_impulse;       ///< sums over all steps of the impulses of the fluid on the beads
  SwimmerLoads inner_momentum;           ///< momenta of the fluid within the beads (psm, saturated_cells.hpp)
  std::vector<BeadVelocity> predicted;   ///< velocities at the end of the next step without close beads
  std::vector<double> removed_fraction;  ///< Impulse::removed_fraction of the beads in the last step

  /// Returns a swimmer with this number of beads, all at rest at the origin.
  static SwimmerState of_beads(std::size_t beads) {
    SwimmerState swimmer;
    visit_bead_fields([&](const char*, auto& of_beads) { of_beads.resize(beads); }, swimmer);
    swimmer.fluid_impulse.assign(beads, Vec3::Zero());
    return swimmer;
  }

  Eigen::Matrix3d orientation_at_start() const {
    Eigen::Matrix3d orientation;
    for (int a = 0; a < 3; ++a) orientation.col(a) = initial_orientation[a];
    return orientation;
  }

  /// Returns the position of the bead in the middle of the list, bead 2 of three. The rank whose block
  /// contains it owns the swimmer.
  const Vec3& middle() const { return motion[motion.size() / 2].position; }

  BEADSWIM_FIELDS(id, type, initial_orientation, dipole_sum, held_mass, mass_source, removed_fraction, motion,
                  last_impulse, fluid_impulse, inner_momentum, predicted)

  /// Visits the fields with one entry per bead. state_sha256() hashes these fields.
  static void visit_bead_fields(auto&& visit, auto& swimmer) {
    const auto visit_lists = [&]<class Field>(const char* name, Field& field) {
      if constexpr (varies_in_size<std::remove_const_t<Field>>) visit(name, field);
    };
    visit_fields(visit_lists, swimmer);
  }
};

/// Complete state of a swimmer between two steps.
struct SwimmerSnapshot {
  SwimmerState state;
  std::vector<Impulse> pending_impulses;  ///< impulses on its beads, not yet applied; sums over all ranks

  BEADSWIM_FIELDS(state, pending_impulses)
};

/// Returns the size of the snapshot of a swimmer with this number of beads [byte].
inline std::size_t snapshot_size(std::size_t beads) {
  return bytes_of(std::vector{SwimmerSnapshot{.state = SwimmerState::of_beads(beads),
                                              .pending_impulses = std::vector<Impulse>(beads)}})
      .size();
}

}  // namespace beadswim
