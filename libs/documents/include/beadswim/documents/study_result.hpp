#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/names.hpp"
#include "beadswim/documents/swimming_document.hpp"

// Results of runs and predictions of which a study draws the dependence, or searches the greatest value.

namespace beadswim {

enum class StudyResult { velocity, efficiency, power, arm_amplitudes, angular_velocity };

template <>
inline constexpr auto name_table<StudyResult> =
    std::to_array<NamedValue<StudyResult>>({{StudyResult::velocity, "velocity"},
                                            {StudyResult::efficiency, "efficiency"},
                                            {StudyResult::power, "power"},
                                            {StudyResult::arm_amplitudes, "arm_amplitudes"},
                                            {StudyResult::angular_velocity, "angular_velocity"}});

/// A result and its absolute uncertainty, which is 0 if none is stated.
struct ResultValue {
  std::string part;  ///< "" or the arm: "d1", "d2"
  double value = 0, error = 0;
};

/// Returns a result of a prediction: one value, or one of each arm. The result is empty if the method gives
/// none. Velocity: along the axis of the swimmer, relative to the mean flow [length/time]. Angular velocity:
/// its size [radian/time]. Power: mean power of the drives [mass length^2/time^3].
std::vector<ResultValue> results_of(const Prediction& prediction, StudyResult result);

/// Returns a result of one swimmer of a run, as above, averaged over the chosen cycles. Throws InputError if
/// the run lacks a chosen cycle.
std::vector<ResultValue> results_of(const RunRecord& run, const SwimmerRecord& swimmer, StudyResult result,
                                    const CycleChoice& cycle, const std::string& source);

}  // namespace beadswim
