#include "beadswim/theory/collinear_swimmer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/core/error.hpp"

namespace beadswim {

namespace {

/// Returns +1 if the driving forces are parallel to the swimmer's axis, -1 if they are antiparallel. Throws
/// InputError if they are neither.
double driving_direction(const ThreeBeadSwimmer& type, const Vec3& axis) {
  if (type.driving.frame != DrivingFrame::lab) return 1;
  if (!stays_on_a_line(type, axis)) {
    throw InputError("axis",
                     "the axis [{}, {}, {}] is not along x, but the driving forces are along x (frame "
                     "\"lab\"), so the motion is not along the axis; theory requires an axis along x, or "
                     "driving with the frame \"initial-axis\" or \"body\"",
                     axis.x(), axis.y(), axis.z());
  }
  return axis.x() > 0 ? 1 : -1;
}

void check_stiffness(const ThreeBeadSwimmer& type) {
  for (int arm = 0; arm < 2; ++arm) {
    if (!(type.springs[arm].stiffness > 0)) {
      throw InputError(fmt::format("springs/{}/stiffness", arm),
                       "a spring stiffness of {} does not fix the mean arm length, so no periodic motion "
                       "exists; theory needs a stiffness above 0",
                       type.springs[arm].stiffness);
    }
  }
}

}  // namespace

double CollinearSwimmer::angular_frequency() const {
  return 2 * std::numbers::pi / period;
}

bool stays_on_a_line(const ThreeBeadSwimmer& type, const Vec3& axis) {
  constexpr double largest_sine = 1e-9;  // largest sine of the angle to x, which roundoff may cause
  return type.driving.frame != DrivingFrame::lab ||
         axis.cross(Vec3::UnitX()).norm() <= largest_sine * axis.norm();
}

CollinearSwimmer collinear_swimmer(const ThreeBeadSwimmer& type, const Vec3& axis, double viscosity) {
  check_stiffness(type);
  const double direction = driving_direction(type, axis);
  CollinearSwimmer swimmer;
  for (int bead = 0; bead < 3; ++bead) {
    swimmer.radius[bead] = type.beads[bead].radius;
    swimmer.density[bead] = type.beads[bead].density;
  }
  for (int arm = 0; arm < 2; ++arm) {
    swimmer.arm[arm] = type.springs[arm].rest_length;
    swimmer.stiffness[arm] = type.springs[arm].stiffness;
    swimmer.damping[arm] = type.springs[arm].damping;
    swimmer.amplitude[arm] = direction * type.driving.amplitude[arm];
  }
  swimmer.phase = type.driving.phase;
  swimmer.phase_offset = type.driving.phase_offset;
  swimmer.period = type.driving.period;
  swimmer.viscosity = viscosity;
  return swimmer;
}

std::optional<CollinearSwimmer> collinear_swimmer(const SwimmerType& type, double viscosity) {
  const std::optional<ThreeBeadSwimmer> three = three_bead_form(type);
  if (!three) return std::nullopt;
  return collinear_swimmer(*three, Vec3::UnitX(), viscosity);
}

std::complex<double> inverse_penetration_depth(const CollinearSwimmer& swimmer, double fluid_density) {
  return std::sqrt(std::complex<double>(0, swimmer.angular_frequency() * fluid_density / swimmer.viscosity));
}

double sphere_mass(double radius, double density) {
  return 4 * std::numbers::pi / 3 * std::pow(radius, 3) * density;
}

LinePositions rest_positions(const CollinearSwimmer& swimmer) {
  return {-swimmer.arm[0], 0, swimmer.arm[1]};
}

std::array<double, 2> gaps_at_rest(const CollinearSwimmer& swimmer) {
  const auto gap = [&](int arm) { return swimmer.arm[arm] - swimmer.radius[arm] - swimmer.radius[arm + 1]; };
  return {gap(0), gap(1)};
}

double separation_ratio(const CollinearSwimmer& swimmer) {
  const auto ratio = [&](int arm) {
    return 2 * swimmer.arm[arm] / (swimmer.radius[arm] + swimmer.radius[arm + 1]);
  };
  return std::min(ratio(0), ratio(1));
}

CollinearMobility rest_mobility(const CollinearSwimmer& swimmer, PairLaw law) {
  return pairwise_mobility(law, swimmer.radius, rest_positions(swimmer), swimmer.viscosity);
}

}  // namespace beadswim
