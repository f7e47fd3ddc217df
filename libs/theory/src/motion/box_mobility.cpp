#include "beadswim/theory/box_mobility.hpp"

#include <vector>

#include "beadswim/scene/bead_gaps.hpp"

namespace beadswim {

CollinearMobility rotne_prager_mobility(const LineFlow& flow, const CollinearSwimmer& swimmer,
                                        const LinePositions& positions) {
  CollinearMobility mobility;
  mobility.slope.fill(Eigen::Matrix3d::Zero());
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double size = swimmer.radius[i] * swimmer.radius[i] + swimmer.radius[j] * swimmer.radius[j];
      const auto [oseen, laplacian] =
          i == j ? flow.steady_images(positions[i]) : flow.steady(positions[i], positions[j]);
      mobility.value(i, j) = oseen.value + size * laplacian.value;
      mobility.slope[i](i, j) += oseen.by_receiver + size * laplacian.by_receiver;
      mobility.slope[j](i, j) += oseen.by_source + size * laplacian.by_source;
    }
    mobility.value(i, i) += self_mobility(swimmer.radius[i], swimmer.viscosity);
  }
  return mobility;
}

LineFlow box_line_flow(const BoxPlace& place, double viscosity) {
  return LineFlow(viscosity, place.box, place.middle_bead[1], place.middle_bead[2]);
}

LinePositions rest_positions(const CollinearSwimmer& swimmer, const BoxPlace& place) {
  LinePositions positions = rest_positions(swimmer);
  for (double& x : positions) x += place.middle_bead[0];
  return positions;
}

double smallest_gap_in_box(const CollinearSwimmer& swimmer, const BoxPlace& place) {
  const LinePositions x = rest_positions(swimmer, place);
  std::vector<PlacedBead> beads;
  for (int i = 0; i < 3; ++i)
    beads.push_back(
        {.centre = Vec3(x[i], place.middle_bead[1], place.middle_bead[2]), .radius = swimmer.radius[i]});
  return smallest_gap(beads, {.box = place.box});
}

}  // namespace beadswim
