#include "beadswim/theory/box_mobility.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace beadswim {

namespace {

/// Returns a message if a bead overlaps a periodic image of a bead along the swimmer's axis, including its
/// own image.
std::optional<std::string> periodic_overlap(const CollinearSwimmer& swimmer, const LinePositions& x,
                                            double period) {
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const double d = x[j] - x[i], contact = swimmer.radius[i] + swimmer.radius[j];
      const int below = static_cast<int>(std::floor(d / period));
      for (const int image : {below, below + 1}) {
        if (image == 0 || std::abs(d - image * period) >= contact) continue;
        return fmt::format(
            "beads {} and {} overlap through the periodic boundary along the swimmer; make the box longer",
            i + 1, j + 1);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

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

std::optional<std::string> image_overlap(const CollinearSwimmer& swimmer, const BoxPlace& place) {
  const LinePositions x = rest_positions(swimmer, place);
  const auto& [box, middle] = place;
  if (!box.has_mirrors(0)) {
    if (auto overlap = periodic_overlap(swimmer, x, box.lengths[0])) return overlap;
  } else if (x[0] < swimmer.radius[0] || x[2] > box.lengths[0] - swimmer.radius[2]) {
    return "bead 1 or bead 3 overlaps a wall perpendicular to the swimmer's axis; make the box longer or "
           "move the swimmer";
  }
  const double largest = *std::max_element(swimmer.radius.begin(), swimmer.radius.end());
  for (const int axis : {1, 2}) {
    const double length = box.lengths[axis];
    const double room = box.has_mirrors(axis) ? std::min(middle[axis], length - middle[axis]) : length / 2;
    if (room < largest) {
      return fmt::format(
          "the box, {:.3g} bead radii wide perpendicular to the swimmer, has no room for a bead; enlarge the "
          "box or move the swimmer",
          length / largest);
    }
  }
  return std::nullopt;
}

}  // namespace beadswim
