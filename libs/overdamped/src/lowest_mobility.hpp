#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/mobility.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"

namespace beadswim {

/// Returns true if spheres are so close to each other or to the wall that Oseen's mobility may have an
/// eigenvalue that is not positive: with centres nearer than twice the sum of the radii, or a height below
/// two radii. (Equal spheres in dense lattices need 3.1 radii between centres, one sphere a height of 9/8
/// radii.)
bool has_close_spheres(std::span<const Vec3> positions, std::span<const double> radii, const Domain& domain);

/// Returns the bead that moves most against some forces if the mobility, in units of that of each bead alone,
/// has an eigenvalue that is not positive. Then these forces gain work from the fluid. `root_mobility`:
/// square root of the mobility of each bead alone. `mode`: guess of the eigenvector of the smallest
/// eigenvalue; becomes the eigenvector, found by the method of Lanczos. Collective.
std::optional<std::size_t> find_reversed_bead(Mobility& mobility, std::span<const Vec3> positions,
                                              const Eigen::VectorXd& root_mobility, Beads& mode,
                                              const Communicator& communicator);

}  // namespace beadswim
