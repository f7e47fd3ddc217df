#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "beadswim/theory/collinear_swimmer.hpp"

// Integrals over all space of functions f(x, s) with the symmetry of a collinear swimmer; s: distance from
// the axis. Composite Gauss rules in the angle and in ln r around each bead, up to the planes in the middle
// of the gaps.

namespace beadswim {

/// Returns positions and weights of the composite Gauss rule with four points in each of `panels` panels.
inline std::vector<std::pair<double, double>> gauss_panels(double from, double to, int panels) {
  const double inner = std::sqrt(3.0 / 7 - 2.0 / 7 * std::sqrt(6.0 / 5)),
               outer = std::sqrt(3.0 / 7 + 2.0 / 7 * std::sqrt(6.0 / 5));
  const double inner_weight = (18 + std::sqrt(30)) / 36, outer_weight = (18 - std::sqrt(30)) / 36;
  const double half = (to - from) / panels / 2;
  std::vector<std::pair<double, double>> nodes;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = from + (2 * panel + 1) * half;
    for (const double side : {-1.0, 1.0}) {
      nodes.emplace_back(middle + side * half * inner, half * inner_weight);
      nodes.emplace_back(middle + side * half * outer, half * outer_weight);
    }
  }
  return nodes;
}

/// Returns the integral of `f` over all space within the distance `reach` of the swimmer, including the
/// beads.
template <class Integrand>
auto integral_over_space(const CollinearSwimmer& swimmer, double reach, int panels, const Integrand& f) {
  const LinePositions center = rest_positions(swimmer);
  decltype(f(0.0, 0.0)) sum = 0 * f(0.0, 0.0);
  for (int bead = 0; bead < 3; ++bead) {
    const double a = swimmer.radius[bead];
    for (const int side : {-1, 1}) {
      double plane = std::numeric_limits<double>::infinity();
      if (const int arm = side < 0 ? bead - 1 : bead; arm == 0 || arm == 1) {
        plane = a + (swimmer.arm[arm] - swimmer.radius[arm] - swimmer.radius[arm + 1]) / 2;
      }
      for (const auto& [angle, angle_weight] : gauss_panels(0, std::numbers::pi / 2, panels)) {
        const double cosine = side * std::cos(angle), sine = std::sin(angle);
        const double ring = 2 * std::numbers::pi * sine * angle_weight;
        for (const auto& [r, weight] : gauss_panels(0, a, panels)) {
          sum += ring * weight * r * r * f(center[bead] + r * cosine, r * sine);
        }
        const double end = std::min(reach, plane / std::abs(cosine));
        for (const auto& [log_r, weight] : gauss_panels(std::log(a), std::log(end), 2 * panels)) {
          const double r = std::exp(log_r);
          sum += ring * weight * r * r * r * f(center[bead] + r * cosine, r * sine);
        }
      }
    }
  }
  return sum;
}

}  // namespace beadswim
