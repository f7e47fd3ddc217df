#include "beadswim/coupling/bead_images.hpp"

namespace beadswim {

BlockInLattice block_in_lattice(const Decomposition& decomposition, int rank,
                                const std::array<Boundary, 3>& boundary) {
  return {.block = decomposition.block(rank), .cells = decomposition.cells(), .boundary = boundary};
}

bool touches(const BlockInLattice& lattice_block, int margin, const Vec3& position, double radius) {
  bool is_found = false;
  for_each_image(lattice_block, margin, position, radius, [&](const BeadImage&) { is_found = true; });
  return is_found;
}

}  // namespace beadswim
