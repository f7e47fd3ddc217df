#pragma once

#include <cstddef>
#include <utility>

#include "beadswim/core/names.hpp"

namespace beadswim {

/// Floating-point precision in which populations are stored and collided. Boundary conditions, beads and
/// totals are evaluated in double precision.
enum class Precision {
  fp64,
  fp32,  ///< half the memory and memory traffic; errors: docs/method/single-precision.md
};

template <>
inline constexpr auto name_table<Precision> =
    std::to_array<NamedValue<Precision>>({{Precision::fp64, "double"}, {Precision::fp32, "single"}});

/// Calls work.operator()<Real>(), where Real is the type in which populations of this precision are stored.
template <class Work>
decltype(auto) in_precision(Precision precision, Work&& work) {
  if (precision == Precision::fp32) return std::forward<Work>(work).template operator()<float>();
  return std::forward<Work>(work).template operator()<double>();
}

/// Returns the size of one stored population [byte].
inline std::size_t bytes_per_population(Precision precision) {
  return in_precision(precision, []<class Real>() { return sizeof(Real); });
}

}  // namespace beadswim
