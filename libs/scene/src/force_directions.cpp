#include "beadswim/scene/check.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/setting.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"

namespace beadswim {
namespace {

/// Returns true if all harmonics of the drives have odd (`remainder` 1) or even (0) multiples.
bool have_multiples(const auto& drives, int remainder) {
  for (const auto& drive : drives)
    for (const Harmonic& harmonic : drive.harmonics)
      if (harmonic.amplitude != 0 && harmonic.multiple % 2 != remainder) return false;
  return true;
}

/// Returns true if forces whose directions are turned by the rotation cause the same stroke: they are equal,
/// or all are reversed, as they are half a period later, when other drives are the same.
bool is_same_driving(const Driving& driving, const Eigen::Matrix3d& rotation) {
  constexpr double largest_sine = 1e-6;  // as axes may deviate from unit vectors
  bool is_equal = true, is_reversed = have_multiples(driving.forces, 1) && have_multiples(driving.bonds, 0) &&
                                      have_multiples(driving.angles, 0);
  for (const auto& [bead, direction, constant, harmonics] : driving.forces) {
    if (constant == 0 && sum_of_amplitudes(harmonics) == 0) continue;
    is_equal = is_equal && (rotation * direction - direction).norm() <= largest_sine;
    is_reversed = is_reversed && constant == 0 && (rotation * direction + direction).norm() <= largest_sine;
  }
  return is_equal || is_reversed;
}

}  // namespace

std::string warning_of_fixed_forces(const Layout& layout) {
  const auto is_left_behind = [&layout](const Swimmer& swimmer) {
    const Driving& driving = layout.driving_of(swimmer);
    return driving.frame == DrivingFrame::lab && !is_same_driving(driving, swimmer.orientation()) &&
           net_forces(driving).empty();
  };
  const auto count = std::ranges::count_if(layout.swimmers, is_left_behind);
  if (count == 0) return "";
  return fmt::format(
      "the driving forces of {} of {} swimmers keep their directions in the box (frame \"lab\"), although "
      "these swimmers are turned, which changes their strokes and velocities; use {} body, with which forces "
      "turn with the swimmers",
      count, layout.swimmers.size(), Setting::frame);
}

}  // namespace beadswim
