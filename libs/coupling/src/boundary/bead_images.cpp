#include "beadswim/coupling/bead_images.hpp"

namespace beadswim {

BlockInLattice block_in_lattice(const Decomposition& decomposition, int rank,
                                const std::array<Boundary, 3>& boundary) {
  return {.block = decomposition.block(rank), .cells = decomposition.cells(), .boundary = boundary};
}

bool touches(const BlockInLattice& at, int margin, const Vec3& position, double radius) {
  bool met = false;
  for_each_image(at, margin, position, radius, [&](const BeadImage&) { met = true; });
  return met;
}

}  // namespace beadswim
