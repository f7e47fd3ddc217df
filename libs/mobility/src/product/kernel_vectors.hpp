#pragma once

#include "beadswim/core/kernel.hpp"

// Vectors of numbers that fit into one register. The compiler moves longer vectors, such as Lanes, to memory
// and back, which costs most of the time of kernels with many intermediate results. Only for files that are
// compiled once per instruction set.

namespace beadswim::BEADSWIM_INSTRUCTION_SET {

#if defined(__AVX512F__)
constexpr int part = 8;  ///< numbers per register
#elif defined(__AVX__)
constexpr int part = 4;
#else
constexpr int part = 2;
#endif
/// Part of the lanes of SourceLanes.
using Part = double __attribute__((vector_size(part * sizeof(double))));

constexpr int quad = 4;  ///< numbers per vector of a row of a window (mesh_window.hpp)
using Quad = double __attribute__((vector_size(quad * sizeof(double))));

template <class Vector>
BEADSWIM_KERNEL Vector load_as(const double* from) {
  Vector values;
  __builtin_memcpy(&values, from, sizeof values);
  return values;
}
template <class Vector>
BEADSWIM_KERNEL void store_as(double* to, const Vector& values) {
  __builtin_memcpy(to, &values, sizeof values);
}

}  // namespace beadswim::BEADSWIM_INSTRUCTION_SET
