#include "beadswim/scene/force_directions.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "beadswim/core/setting.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"

namespace beadswim {
namespace {

bool is_zero(const ForceDrive& drive) {
  return drive.constant == 0 && sum_of_amplitudes(drive.harmonics) == 0;
}

/// Returns true if, half a period later, all forces are reversed and all other drives are the same.
bool reverses_forces_in_half_a_period(const Driving& driving) {
  const auto multiples_have = [](const auto& drives, int remainder) {
    return std::ranges::all_of(drives, [remainder](const auto& drive) {
      return std::ranges::all_of(drive.harmonics, [remainder](const Harmonic& harmonic) {
        return harmonic.amplitude == 0 || harmonic.multiple % 2 == remainder;
      });
    });
  };
  return std::ranges::all_of(driving.forces, [](const ForceDrive& drive) { return drive.constant == 0; }) &&
         multiples_have(driving.forces, 1) && multiples_have(driving.bonds, 0) &&
         multiples_have(driving.angles, 0);
}

/// Returns true if forces whose directions are turned by the rotation cause the same stroke.
bool is_same_driving(const Driving& driving, const Eigen::Matrix3d& rotation) {
  constexpr double largest_sine = 1e-6;  // as axes may deviate from unit vectors
  const auto all_become = [&](double sign) {
    return std::ranges::all_of(driving.forces, [&](const ForceDrive& drive) {
      return is_zero(drive) || (rotation * drive.direction - sign * drive.direction).norm() <= largest_sine;
    });
  };
  return all_become(1) || (reverses_forces_in_half_a_period(driving) && all_become(-1));
}

}  // namespace

std::string warning_of_fixed_forces(const Layout& layout) {
  const auto is_left_behind = [&layout](const Swimmer& swimmer) {
    const Driving& driving = swimmer.driving ? *swimmer.driving : layout.types.at(swimmer.type).driving;
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
