#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "beadswim/coupling/coupled_system.hpp"
#include "beadswim/run/model.hpp"
#include "beadswim/scene/unit_scales.hpp"

namespace beadswim {

/// The present flow on the lattice, in units of the layout. Cells within a bead have its velocity; the
/// pressure is relative to the fluid at rest, and 0 within beads.
class LatticeFlow {
 public:
  LatticeFlow(const CoupledSystem& system, const UnitScales& scales, const Communicator& communicator);

  /// Writes velocity, pressure and bead for each cell to one file per level: the bead is the number of the
  /// bead that covers the cell (0: none). Collective.
  void write(const std::vector<std::string>& files) const;

  /// Returns the flow at points [length]: inside beads their velocity, otherwise a trilinear interpolation
  /// between the cells of the finest level around the point. Complete on rank 0. Collective.
  std::vector<PointFlow> at(std::span<const Vec3> points) const;

 private:
  struct CoveredCell {
    const BeadOnLattice* bead;
    Vec3 from_centre;  ///< of the bead to the centre of the cell
  };
  struct Corner;
  PointFlow in_cell(int level, std::ptrdiff_t cell, const Vec3& from_centre_of_cell) const;
  bool find_corners(int level, const Vec3& point, std::span<Corner> corners) const;
  void write_level(int number, const std::string& file) const;

  const CoupledSystem& system_;
  const Levels& levels_;
  const UnitScales& scales_;
  const Communicator& communicator_;
  std::unordered_map<std::ptrdiff_t, CoveredCell>
      covered_;                                      ///< cells of the finest level; they have no fluid
  std::unordered_map<std::ptrdiff_t, Vec3> forces_;  ///< half of a force of a bead belongs to the velocity
};

}  // namespace beadswim
