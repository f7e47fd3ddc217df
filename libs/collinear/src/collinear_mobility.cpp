#include "beadswim/collinear/collinear_mobility.hpp"

namespace beadswim {

CollinearMobility pairwise_mobility(PairLaw law, const std::array<double, 3>& radii,
                                    const LinePositions& positions, double viscosity) {
  CollinearMobility mobility;
  mobility.slope.fill(Eigen::Matrix3d::Zero());
  for (int i = 0; i < 3; ++i) {
    mobility.value(i, i) = self_mobility(radii[i], viscosity);
    for (int j = i + 1; j < 3; ++j) {
      const PairMobility pair = law(radii[i], radii[j], positions[j] - positions[i], viscosity);
      mobility.value(i, j) = mobility.value(j, i) = pair.value;
      mobility.slope[i](i, j) = mobility.slope[i](j, i) = -pair.slope;
      mobility.slope[j](i, j) = mobility.slope[j](j, i) = pair.slope;
    }
  }
  return mobility;
}

}  // namespace beadswim
