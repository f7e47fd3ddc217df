#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace beadswim {

// Quantisation stores a number as a 16-bit integer:  number = integer × step, |integer| <= 32767.

/// Integer that represents NaN.
inline constexpr std::int16_t not_a_number = -32768;

/// Returns the smallest step with which every number up to the absolute value `largest` can be stored in 16
/// bits; 0 if `largest` is 0.
float smallest_step(double largest);

/// Returns number / step, rounded to the nearest integer, or `not_a_number` for NaN. The rounding error is at
/// most half a step.
std::int16_t round_to_steps(double number, float step);

/// Table of numbers that are stored as integer multiples of a step. Each column has the smallest step that
/// can store its largest number.
struct QuantisedTable {
  std::vector<float> steps;          ///< one per column
  std::vector<std::int16_t> values;  ///< row by row
};

/// Converts a table, whose values are given row by row, to integers and steps.
QuantisedTable quantised(std::span<const double> rows, std::size_t columns);

}  // namespace beadswim
