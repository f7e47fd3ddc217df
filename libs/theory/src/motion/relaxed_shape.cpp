#include <Eigen/QR>
#include <algorithm>

#include "beadswim/core/error.hpp"
#include "beadswim/swimmers/swimmer_matrices.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "shape_flow.hpp"

namespace beadswim {

BeadVectors relaxed_shape(const ShapedSwimmer& swimmer) {
  const SwimmerType& type = swimmer.type;
  std::vector<Vec3> places;
  double size = 0;
  for (const BeadAtRest& bead : type.beads) {
    places.push_back(bead.at);
    size = std::max(size, bead.at.norm());
  }
  BeadVectors beads = columns_of_beads(places);
  constexpr int max_steps = 100;
  constexpr double converged = 1e-13;
  for (int step = 0;; ++step) {
    const Eigen::VectorXd forces = own_forces<Eigen::Dynamic>(type, 0, beads);
    const Eigen::MatrixXd stiffness = own_stiffness<Eigen::Dynamic>(type, 0, beads);
    // The smallest displacement that balances the forces; rigid motion and free deformations stay as they
    // are.
    const Eigen::VectorXd change = stiffness.completeOrthogonalDecomposition().solve(forces);
    beads += as_beads(change);
    if (change.cwiseAbs().maxCoeff() <= converged * size) break;
    if (step == max_steps || !beads.allFinite())
      throw InputError("the swimmer's shape at rest",
                       "the springs find no shape in which they exert no forces; give bonds and "
                       "angles rest lengths and rest angles that fit together");
  }
  beads = centred(beads);
  const Eigen::Matrix3d fit = fitted_orientation(type, beads, Eigen::Matrix3d::Identity());
  return swimmer.orientation * fit.transpose() * beads;
}

}  // namespace beadswim
