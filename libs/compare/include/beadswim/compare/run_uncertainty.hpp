#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>

#include "beadswim/core/fields.hpp"

// Errors of the velocity and the arm amplitudes that are expected in a run, and their uncertainties, relative
// to their values in the last cycle.

namespace beadswim {

/// Expected relative errors of a swimmer's velocity and arm amplitudes in a run.
struct ErrorEstimate {
  double velocity = 0;
  std::array<double, 2> arm_amplitudes{};

  double largest_of_arms() const { return std::max(arm_amplitudes[0], arm_amplitudes[1]); }
  double largest() const { return std::max(velocity, largest_of_arms()); }  ///< maximum of all errors

  BEADSWIM_FIELDS(velocity, arm_amplitudes)
};

/// Returns a relative error as text in per cent: two digits below 100 %, no decimals above, and "more than
/// 1000 %" for larger values.
std::string in_percent(double share);

/// Limits of the relative errors that are expected in a run, by cause: the largest of all its swimmers.
struct ExpectedErrors {
  ErrorEstimate total;       ///< difference from the motion of the scene at infinite resolution
  ErrorEstimate resolution;  ///< by cells and time steps, or by the accuracy of mobility products
  ErrorEstimate wander;      ///< by the place of the beads within cells; 0 without a lattice
  ErrorEstimate box;         ///< not an error: change by walls and images, compared with open space
};

/// Relative uncertainties of one quantity in the last cycle of a run, by cause; nullopt: unknown.
struct QuantityUncertainty {
  std::optional<double> resolution{};  ///< by cells and time steps, or by the accuracy of mobility products
  std::optional<double> wander{};      ///< by the place of the beads within cells of the lattice
  std::optional<double> transient{};   ///< by the start of the run: remaining_change() of the cycles
  std::optional<double> total{};       ///< root of the sum of squares of the three
  std::optional<double> box{};  ///< not in `total`: change by walls and images, compared with open space

  BEADSWIM_FIELDS(resolution, wander, transient, total, box)
};

/// Uncertainties of the last cycle of a swimmer; for the arm amplitudes, those of the arm with the larger
/// total.
struct SwimmerUncertainty {
  QuantityUncertainty velocity, arm_amplitudes;

  BEADSWIM_FIELDS(velocity, arm_amplitudes)
};

/// Returns the root of the sum of squares of resolution, wander and transient; nullopt if one of them is
/// unknown.
std::optional<double> total_uncertainty(const QuantityUncertainty& uncertainty);

/// Estimates how far a quantity will still change after the last cycle, relative to its last value. `values`:
/// the quantity in successive cycles. The changes from cycle to cycle are assumed to decrease by a constant
/// ratio r, so that the remaining change is r/(1 - r) times the last one. r is the ratio of the last two
/// changes, but at least 1/2 and at most 9/10; it is 1/2 if the last two changes do not decrease or if there
/// is only one change. Returns nullopt for fewer than two values, or if the last value is zero.
std::optional<double> remaining_change(std::span<const double> values);

}  // namespace beadswim
