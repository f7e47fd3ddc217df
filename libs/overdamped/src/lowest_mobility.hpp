#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "beadswim/core/communicator.hpp"
#include "beadswim/overdamped/overdamped_scene.hpp"

namespace beadswim {

/// Watches the smallest eigenvalue of the mobility of all beads, in units of the mobility of each bead alone.
/// Where it is not positive, some forces move beads backwards and gain work from the fluid. The eigenvector
/// is found by the method of Lanczos, which starts from that of the last call.
class LowestMobility {
 public:
  /// All arguments must exist as long as the object.
  LowestMobility(const OverdampedScene& scene, const MobilityProduct& mobility, std::span<const double> radii,
                 const Communicator& communicator);

  /// Returns the bead with the largest part in the eigenvector if the eigenvalue is not positive. Collective.
  std::optional<std::size_t> reversed_bead(std::span<const Vec3> positions);

 private:
  Eigen::VectorXd product(std::span<const Vec3> positions, const Eigen::VectorXd& mode) const;

  const MobilityProduct& mobility_;
  const Communicator& communicator_;
  Eigen::VectorXd root_drag_;  ///< square root of the drag coefficient of the bead of each component
  Eigen::VectorXd mode_;       ///< eigenvector
};

}  // namespace beadswim
