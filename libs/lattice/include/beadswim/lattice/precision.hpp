#pragma once

#include <cstddef>
#include <string>
#include <utility>

namespace beadswim {

/// The numbers in which populations are stored and collided. Whatever is computed beside the sweep (boundary
/// conditions, beads, totals) is computed in double precision.
enum class Precision {
  fp64,
  fp32,  ///< half the memory and traffic; docs/method/single-precision.md says what it costs
};

/// Calls work.operator()<Real>(), Real being the type in which populations of this precision are stored.
template <class Work>
decltype(auto) in_precision(Precision precision, Work&& work) {
  if (precision == Precision::fp32) return std::forward<Work>(work).template operator()<float>();
  return std::forward<Work>(work).template operator()<double>();
}

inline std::size_t bytes_of_number(Precision precision) {
  return in_precision(precision, []<class Real>() { return sizeof(Real); });
}

/// As on command lines and in records: "double" or "single".
inline std::string name_of(Precision precision) {
  return precision == Precision::fp32 ? "single" : "double";
}

}  // namespace beadswim
