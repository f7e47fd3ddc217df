#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "beadswim/core/names.hpp"
#include "beadswim/core/vec3.hpp"

// The list of results of a swimmer that runs and predictions state. documents/results.hpp reads them.

namespace beadswim {

/// Results of one swimmer, means over a cycle. result_rows says what they are.
enum class ResultQuantity {
  velocity,
  velocity_x,
  velocity_y,
  velocity_z,
  speed_along_axis,
  speed_across_axis,
  angular_velocity,
  angular_velocity_x,
  angular_velocity_y,
  angular_velocity_z,
  arm_amplitudes,
  arm_phases,
  sin_phase_shift,
  power,
  efficiency,
  gap,
  dipole,
  effective_diffusion,
  rotational_diffusion,
  peclet,
};

/// Kinds of quantities with equal units: 1, radian, length, length/time, radian/time, mass length^2/time^3,
/// mass length^2/time^2, length^2/time, 1/time.
enum class Dimension { number, angle, length, velocity, angular_velocity, power, energy, diffusion, rate };

struct ResultRow {
  ResultQuantity quantity;
  std::string_view name;  ///< in flags and documents
  Dimension dimension;
  std::string_view label;     ///< in figures
  std::string_view symbol{};  ///< in tables, if it is not the label; of one arm with its number
  bool is_per_arm = false;    ///< false: the quantity has one number
};

/// velocity: along the axis of the swimmer, compared as a vector. Velocities are relative to the mean flow;
/// their components x, y, z are those in the box. speed_along_axis: the component along the axis alone, with
/// its sign. speed_across_axis: size of the component perpendicular to the axis. angular_velocity: its size.
/// arm_amplitudes, arm_phases: d and delta of equation (4.1) of the paper (Pickl et al. 2017). gap: the
/// smallest between the surfaces of the two beads of an arm. effective_diffusion, rotational_diffusion,
/// peclet: with thermal noise (compare/diffusion.hpp).
// clang-format off
inline constexpr auto result_rows = std::to_array<ResultRow>({
    {ResultQuantity::velocity, "velocity", Dimension::velocity, "velocity"},
    {ResultQuantity::velocity_x, "velocity_x", Dimension::velocity, "velocity, x"},
    {ResultQuantity::velocity_y, "velocity_y", Dimension::velocity, "velocity, y"},
    {ResultQuantity::velocity_z, "velocity_z", Dimension::velocity, "velocity, z"},
    {ResultQuantity::speed_along_axis, "speed_along_axis", Dimension::velocity, "speed along the axis"},
    {ResultQuantity::speed_across_axis, "speed_across_axis", Dimension::velocity, "speed across the axis"},
    {ResultQuantity::angular_velocity, "angular_velocity", Dimension::angular_velocity, "angular velocity"},
    {ResultQuantity::angular_velocity_x, "angular_velocity_x", Dimension::angular_velocity, "angular velocity, x"},
    {ResultQuantity::angular_velocity_y, "angular_velocity_y", Dimension::angular_velocity, "angular velocity, y"},
    {ResultQuantity::angular_velocity_z, "angular_velocity_z", Dimension::angular_velocity, "angular velocity, z"},
    {ResultQuantity::arm_amplitudes, "arm_amplitudes", Dimension::length, "arm amplitude", "d", true},
    {ResultQuantity::arm_phases, "arm_phases", Dimension::angle, "arm phase", "delta", true},
    {ResultQuantity::sin_phase_shift, "sin_phase_shift", Dimension::number, "sine of the phase shift", "sin(delta1 - delta2)"},
    {ResultQuantity::power, "power", Dimension::power, "mean power of the drives", "power"},
    {ResultQuantity::efficiency, "efficiency", Dimension::number, "Lighthill efficiency", "efficiency"},
    {ResultQuantity::gap, "gap", Dimension::length, "smallest gap of an arm", "gap"},
    {ResultQuantity::dipole, "dipole", Dimension::energy, "force dipole along the axis", "dipole"},
    {ResultQuantity::effective_diffusion, "effective_diffusion", Dimension::diffusion, "effective diffusion"},
    {ResultQuantity::rotational_diffusion, "rotational_diffusion", Dimension::rate, "rotational diffusion"},
    {ResultQuantity::peclet, "peclet", Dimension::number, "Peclet number"},
});
// clang-format on

template <>
inline constexpr auto name_table<ResultQuantity> = [] {
  std::array<NamedValue<ResultQuantity>, result_rows.size()> names{};
  std::ranges::transform(result_rows, names.begin(), [](const ResultRow& row) {
    return NamedValue<ResultQuantity>{row.quantity, row.name};
  });
  return names;
}();

constexpr const ResultRow& row_of(ResultQuantity quantity) {
  return *std::ranges::find(result_rows, quantity, &ResultRow::quantity);
}

/// Returns the symbol of a number per arm, "d1"; empty for other quantities.
inline std::string arm_symbol(ResultQuantity quantity, std::size_t arm) {
  const ResultRow& row = row_of(quantity);
  return row.is_per_arm ? std::string(row.symbol) + std::to_string(arm + 1) : "";
}

/// The value of a quantity.
struct ResultValue {
  std::vector<double> numbers;   ///< one number, or one per arm
  std::optional<Vec3> vector{};  ///< in the box: `numbers` is its size, or its component along the axis
  std::vector<double> uncertainties{};  ///< relative, one per number; empty: none is stated
  bool is_mean = false;  ///< mean of a run with thermal noise: the uncertainties are standard errors

  /// Returns the relative uncertainty of a number; nullopt if none is stated.
  std::optional<double> uncertainty(std::size_t i) const {
    return i < uncertainties.size() ? std::optional(uncertainties[i]) : std::nullopt;
  }
  /// Returns the absolute uncertainty of a number; 0 if none is stated.
  double error(std::size_t i) const { return uncertainty(i).value_or(0) * std::abs(numbers[i]); }
};

/// Results of one swimmer, of a run or of a prediction. A source may state only some of them.
using Results = std::map<ResultQuantity, ResultValue>;

/// Returns how many numbers of a quantity the results state.
inline std::size_t count_numbers(const Results& results, ResultQuantity quantity) {
  const auto found = results.find(quantity);
  return found == results.end() ? 0 : found->second.numbers.size();
}

/// Returns number `i` of a quantity; nullopt if the results do not state it.
inline std::optional<double> number_of(const Results& results, ResultQuantity quantity, std::size_t i = 0) {
  if (i >= count_numbers(results, quantity)) return std::nullopt;
  return results.at(quantity).numbers[i];
}

}  // namespace beadswim
