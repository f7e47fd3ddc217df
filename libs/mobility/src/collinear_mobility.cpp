#include "beadswim/mobility/collinear_mobility.hpp"

namespace beadswim {

namespace {

Eigen::Matrix3d symmetric_entry(int i, int j, double entry) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  matrix(i, j) = matrix(j, i) = entry;
  return matrix;
}

}  // namespace

CollinearMobility pairwise_mobility(PairLaw law, const std::array<double, 3>& radii,
                                    const std::array<double, 2>& arms, double viscosity) {
  const PairMobility pair_12 = law(radii[0], radii[1], arms[0], viscosity);
  const PairMobility pair_23 = law(radii[1], radii[2], arms[1], viscosity);
  const PairMobility pair_13 = law(radii[0], radii[2], arms[0] + arms[1], viscosity);

  CollinearMobility mobility;
  mobility.value.diagonal() << self_mobility(radii[0], viscosity), self_mobility(radii[1], viscosity),
      self_mobility(radii[2], viscosity);
  mobility.value(0, 1) = mobility.value(1, 0) = pair_12.value;
  mobility.value(1, 2) = mobility.value(2, 1) = pair_23.value;
  mobility.value(0, 2) = mobility.value(2, 0) = pair_13.value;
  // Beads 1 and 3 are as far apart as both arms together, so their pair depends on either arm alike.
  const Eigen::Matrix3d outer_slope = symmetric_entry(0, 2, pair_13.slope);
  mobility.slope[0] = symmetric_entry(0, 1, pair_12.slope) + outer_slope;
  mobility.slope[1] = symmetric_entry(1, 2, pair_23.slope) + outer_slope;
  return mobility;
}

}  // namespace beadswim
