#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace beadswim {

// Numbers as whole multiples of a step, in 16 bits:  number = steps × step, |steps| <= 32767.

/// Stands for a number that is none.
inline constexpr std::int16_t not_a_number = -32768;

/// The step with which numbers of that size at most fit, 0 if there is none but 0.
float step_for(double largest);

/// The number in steps, rounded to the nearest: wrong by half a step at most. `not_a_number` for NaN.
std::int16_t in_steps(double number, float step);

/// A table of rows of numbers, each column with a step of its own that its largest number needs.
struct QuantisedTable {
  std::vector<float> steps;          ///< of each column
  std::vector<std::int16_t> values;  ///< row by row
};
QuantisedTable quantised(std::span<const double> rows, std::size_t columns);

}  // namespace beadswim
