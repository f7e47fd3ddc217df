#pragma once

#include <functional>
#include <span>
#include <string>

#include "beadswim/lattice/block.hpp"
#include "beadswim/lattice/halo.hpp"
#include "beadswim/lattice/populations.hpp"
#include "beadswim/lattice/trt.hpp"

namespace beadswim {

/// Returns the coordinate z of the plane that a time step sweeps as number n = 0, 1, ... `planes` is the
/// number of planes of constant z in the block. The order of z is 2, 3, ..., planes - 1, 0, 1, so that the
/// two outermost planes on each side come last. Only the rows of these four planes, and bead links next to
/// these rows, read the halo beyond the faces perpendicular to z. The messages that fill this halo may
/// therefore be in transit while the other planes are swept.
constexpr int plane_in_order(int n, int planes) {
  return (n + 2) % planes;
}
/// Inverse of plane_in_order(): returns the number n of the plane at z.
constexpr int order_of_plane(int z, int planes) {
  return (z + 2 * planes - 2) % planes;
}
/// Returns the number n, in the order of plane_in_order(), of the first plane whose sweep needs the complete
/// halo. All planes before it can be swept while messages along z are in transit.
constexpr int first_outer_plane(int planes) {
  return planes > 4 ? planes - 4 : 0;
}

/// Functions that a step of the fluid calls. An empty function is not called.
struct StepCallbacks {
  /// Called before the row (y, z) is swept, when the halo cells that the row reads are filled. It must apply
  /// the boundary condition on the links of this row (links end at a bead) that have not been processed yet:
  /// links within the row, and links between the row and rows that have not been swept.
  std::function<void(int y, int z)> before_row = {};
  /// Called before and after all rows of a plane are swept.
  std::function<void(int z)> before_plane = {}, after_plane = {};
};

/// Advances the fluid of a block by one time step: fills the halo, then streams and collides the populations
/// row by row. Each cell of the block reads its 19 incoming populations, collides them and writes its 19
/// outgoing populations, in a loop without branches. body_force: momentum that each cell gains in this step
/// (body_force.hpp). `skipped`: cells that the step leaves as they are, in local coordinates, sorted by x.
///
/// The results have the same bits for every instruction set and every shape of block.
void step_fluid(Populations& populations, Halo& halo, const RelaxationRates& rates,
                const Vec3& body_force = Vec3::Zero(), const StepCallbacks& callbacks = {},
                std::span<const Block> skipped = {});

/// Streams and collides all cells of a block. All incoming populations must have been set. `row_ends` selects
/// how the sweep fills the halo cells at the ends of each row for the next step (Halo::row_ends()).
void stream_and_collide(Populations& populations, const RelaxationRates& rates,
                        RowEnds row_ends = RowEnds::left_to_halo, const Vec3& body_force = Vec3::Zero());

/// Returns the body force that may act instead of `body_force` on populations of this precision. In single
/// precision it has so few binary digits that a population takes it up without rounding. Other errors would
/// not average out, because they are equal in many cells and steps.
Vec3 acting_body_force(const Vec3& body_force, Precision precision);

/// Returns the instruction set that the kernels use on this processor: "x86-64-v4", "x86-64-v3" or
/// "baseline".
std::string sweep_instruction_set();

}  // namespace beadswim
