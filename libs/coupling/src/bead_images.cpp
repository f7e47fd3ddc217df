#include "beadswim/coupling/bead_images.hpp"

namespace beadswim {

BlockInLattice block_in_lattice(const Decomposition& decomposition, int rank,
                                const std::array<Wall, 3>& walls) {
  BlockInLattice at{.block = decomposition.block(rank), .cells = decomposition.cells(), .periodic = {}};
  for (int a = 0; a < 3; ++a) {
    at.periodic[a] = walls[a] == Wall::periodic;
    at.no_slip[a] = walls[a] == Wall::no_slip;
  }
  return at;
}

bool touches(const BlockInLattice& at, int margin, const Vec3& position, double radius) {
  bool met = false;
  for_each_image(at, margin, position, radius, [&](const BeadImage&) { met = true; });
  return met;
}

}  // namespace beadswim
