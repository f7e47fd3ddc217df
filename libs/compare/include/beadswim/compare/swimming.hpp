#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/compare/cycle_statistics.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/core/names.hpp"

// What runs and predictions are compared by.

namespace beadswim {

enum class ComparedQuantity { velocity, arm_amplitudes, sin_phase_shift };

template <>
inline constexpr auto name_table<ComparedQuantity> =
    std::to_array<NamedValue<ComparedQuantity>>({{ComparedQuantity::velocity, "velocity"},
                                                 {ComparedQuantity::arm_amplitudes, "arm_amplitudes"},
                                                 {ComparedQuantity::sin_phase_shift, "sin_phase_shift"}});

/// How a swimmer swims, whatever says so; a source may know only some of the quantities.
///   velocity         { v }       along the swimmer's axis, in the frame of zero volume flux [length/time]
///   arm_amplitudes   { d1, d2 }  of (4.1) [length]
///   sin_phase_shift  { sin beta }, beta = delta1 - delta2
using Swimming = std::map<ComparedQuantity, std::vector<double>>;

/// velocity - mean_flow along the periodic axes, projected on the swimmer's axis. Across a wall-bounded axis
/// the walls fix the frame, and the mean flow stays in.
double velocity_against_fluid(const CycleStatistics& cycle, const std::optional<Box>& box);

Swimming swimming_in(const CycleStatistics& cycle, const std::optional<Box>& box);

/// Arithmetic mean of each quantity over cycles that hold the same quantities; `cycles` is not empty.
Swimming mean_swimming(std::span<const Swimming> cycles);

}  // namespace beadswim
