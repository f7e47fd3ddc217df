#pragma once

#include <cstddef>
#include <utility>

#include "beadswim/core/names.hpp"

namespace beadswim {

/// The numbers in which populations are stored and collided. Whatever is computed beside the sweep (boundary
/// conditions, beads, totals) is computed in double precision.
enum class Precision {
  fp64,
  fp32,  ///< half the memory and traffic; docs/method/single-precision.md says what it costs
};

template <>
inline constexpr auto name_table<Precision> =
    std::to_array<NamedValue<Precision>>({{Precision::fp64, "double"}, {Precision::fp32, "single"}});

/// Calls work.operator()<Real>(), Real being the type in which populations of this precision are stored.
template <class Work>
decltype(auto) in_precision(Precision precision, Work&& work) {
  if (precision == Precision::fp32) return std::forward<Work>(work).template operator()<float>();
  return std::forward<Work>(work).template operator()<double>();
}

inline std::size_t bytes_of_number(Precision precision) {
  return in_precision(precision, []<class Real>() { return sizeof(Real); });
}

}  // namespace beadswim
