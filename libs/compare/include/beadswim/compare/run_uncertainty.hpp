#pragma once

#include <optional>
#include <span>

#include "beadswim/core/fields.hpp"

// Uncertainties of the velocity and the arm amplitudes of a run, relative to their values in the last cycle.

namespace beadswim {

/// Relative uncertainties of one quantity in the last cycle of a run, by cause; nullopt: unknown.
struct QuantityUncertainty {
  std::optional<double> resolution =
      {};                                ///< by cells and time steps, or by the accuracy of mobility products
  std::optional<double> wander = {};     ///< by the place of the beads within cells of the lattice
  std::optional<double> transient = {};  ///< by the start of the run: remaining_change() of the cycles
  std::optional<double> total = {};      ///< root of the sum of squares of the three
  std::optional<double> box =
      {};  ///< not part of `total`: change by walls and images, compared with open space

  static void visit_fields(auto&& visit, auto& uncertainty) {
    visit("resolution", uncertainty.resolution);
    visit("wander", uncertainty.wander);
    visit("transient", uncertainty.transient);
    visit("total", uncertainty.total);
    visit("box", uncertainty.box);
  }
};

/// Uncertainties of the last cycle of a swimmer; for the arm amplitudes, those of the arm with the larger
/// total.
struct SwimmerUncertainty {
  QuantityUncertainty velocity, arm_amplitudes;

  static void visit_fields(auto&& visit, auto& uncertainty) {
    visit("velocity", uncertainty.velocity);
    visit("arm_amplitudes", uncertainty.arm_amplitudes);
  }
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
