#include "beadswim/theory/periodic_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "beadswim/theory/linear_response.hpp"

namespace beadswim {

namespace {

constexpr double max_amplitude_over_gap = 0.02;  // arm amplitude divided by gap at rest

/// Mobility in open space for arm lengths close to rest, by cubic interpolation in each arm length. The
/// interpolation needs 16 evaluations of the mobility. Without interpolation, the periodic motion needs some
/// hundred evaluations.
class InterpolatedMobility {
 public:
  InterpolatedMobility(const CollinearSwimmer& swimmer, const MobilityFunction& mobility)
      : rest_(swimmer.arm) {
    const std::array<double, 2> gaps = gaps_at_rest(swimmer);
    for (int arm = 0; arm < 2; ++arm) unit_[arm] = 1.5 * max_amplitude_over_gap * gaps[arm];
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const double L1 = rest_[0] + nodes[i] * unit_[0], L2 = rest_[1] + nodes[j] * unit_[1];
        values_[i][j] = mobility({-L1, 0, L2}).value;
      }
    }
  }

  CollinearMobility operator()(const LinePositions& x) const {
    const Weights a = weights((x[1] - x[0] - rest_[0]) / unit_[0]);
    const Weights b = weights((x[2] - x[1] - rest_[1]) / unit_[1]);
    CollinearMobility mobility{.value = combined(a.value, b.value), .slope = {}};
    mobility.slope[0] = -combined(a.slope, b.value) / unit_[0];
    mobility.slope[2] = combined(a.value, b.slope) / unit_[1];
    mobility.slope[1] = -mobility.slope[0] - mobility.slope[2];
    return mobility;
  }

 private:
  static constexpr std::array<double, 4> nodes{-1, -1.0 / 3, 1.0 / 3, 1};

  struct Weights {
    std::array<double, 4> value{}, slope{};
  };

  /// Returns the Lagrange polynomials of the nodes, and their derivatives, at t.
  static Weights weights(double t) {
    Weights result;
    for (int i = 0; i < 4; ++i) {
      double value = 1, slope = 0;
      for (int j = 0; j < 4; ++j) {
        if (j == i) continue;
        const double factor = (t - nodes[j]) / (nodes[i] - nodes[j]);
        slope = slope * factor + value / (nodes[i] - nodes[j]);
        value *= factor;
      }
      result.value[i] = value;
      result.slope[i] = slope;
    }
    return result;
  }

  Eigen::Matrix3d combined(const std::array<double, 4>& a, const std::array<double, 4>& b) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) sum += a[i] * b[j] * values_[i][j];
    }
    return sum;
  }

  std::array<double, 2> rest_, unit_{};
  std::array<std::array<Eigen::Matrix3d, 4>, 4> values_;
};

/// Returns a factor s by which the driving amplitudes are multiplied, so small that arm amplitudes and mean
/// changes of the arm lengths are much smaller than the gaps between the beads.
double small_driving(const CollinearSwimmer& swimmer, const PeriodicMotion& motion) {
  const std::array<double, 2> gaps = gaps_at_rest(swimmer);
  double size = 0;
  for (int arm = 0; arm < 2; ++arm) {
    size = std::max({size, motion.stroke.amplitude[arm] / gaps[arm],
                     std::sqrt(std::abs(motion.arm_changes[arm]) / gaps[arm])});
  }
  return max_amplitude_over_gap / size;
}

}  // namespace

double finite_amplitude_change(const CollinearSwimmer& swimmer, const MobilityFunction& mobility) {
  const LinePositions rest = rest_positions(swimmer);
  if (!(smallest_gap(swimmer, rest) > 0)) return std::numeric_limits<double>::quiet_NaN();
  const InterpolatedMobility near_rest(swimmer, mobility);
  const PeriodicMotion motion = second_order_motion(swimmer, near_rest(rest));
  constexpr double relative_roundoff = 1e-10;
  const double roundoff = relative_roundoff * second_order_scale(swimmer, motion.stroke);
  if (!(std::abs(motion.velocity) > roundoff)) return 0;
  const double s = small_driving(swimmer, motion);
  CollinearSwimmer weakly_driven = swimmer;
  for (double& amplitude : weakly_driven.amplitude) amplitude *= s;
  const double velocity = periodic_motion(weakly_driven, rest, near_rest).velocity;
  return (velocity / (s * s * motion.velocity) - 1) / (s * s);
}

}  // namespace beadswim
