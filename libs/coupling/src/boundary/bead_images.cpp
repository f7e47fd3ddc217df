#include "beadswim/coupling/bead_images.hpp"

namespace beadswim {

bool touches(const BlockInLattice& lattice_block, int margin, const Vec3& position, double radius) {
  bool is_found = false;
  for_each_image(lattice_block, margin, position, radius, [&](const BeadImage&) { is_found = true; });
  return is_found;
}

}  // namespace beadswim
