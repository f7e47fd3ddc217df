#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>

#include "beadswim/core/fields.hpp"

namespace beadswim {

/// Expected relative errors of a swimmer's velocity and arm amplitudes in a run.
struct ErrorEstimate {
  double velocity = 0;
  std::array<double, 2> arm_amplitudes{};

  double largest_of_arms() const { return std::max(arm_amplitudes[0], arm_amplitudes[1]); }
  double largest() const { return std::max(velocity, largest_of_arms()); }  ///< maximum of all errors

  static void visit_fields(auto&& visit, auto& error) {
    visit("velocity", error.velocity, omitted_if(0));  // zero if no swimmer swims
    visit("arm_amplitudes", error.arm_amplitudes);
  }
};

/// Returns a relative error as text in per cent: two digits below 100 %, no decimals above, and "more than
/// 1000 %" for larger values.
inline std::string in_percent(double share) {
  if (share > 10) return "more than 1000 %";
  return share < 1 ? fmt::format("{:.2g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
}

/// Limits of the relative errors that are expected in a run, by cause: the largest of all its swimmers.
struct ExpectedErrors {
  ErrorEstimate total;       ///< difference from the motion of the scene at infinite resolution
  ErrorEstimate resolution;  ///< by cells and time steps, or by the accuracy of mobility products
  ErrorEstimate wander;      ///< by the place of the beads within cells; 0 without a lattice
  ErrorEstimate box;         ///< not an error: change by walls and images, compared with open space
};

}  // namespace beadswim
