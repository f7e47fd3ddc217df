#pragma once

#include "beadswim/core/kernel.hpp"

// Vectors of numbers for kernels, which process one cell, link or pair of spheres in each lane. All functions
// in this file are always inlined (kernel.hpp).

namespace beadswim {

constexpr int lanes = 8;  ///< numbers per vector
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

/// Loads consecutive numbers of type double or float.
template <class Real>
BEADSWIM_KERNEL Lanes load(const Real* from) {
  Real __attribute__((vector_size(lanes * sizeof(Real)))) stored;
  __builtin_memcpy(&stored, from, sizeof stored);
  return __builtin_convertvector(stored, Lanes);
}

/// Stores consecutive numbers.
BEADSWIM_KERNEL void store(double* to, const Lanes& values) {
  __builtin_memcpy(to, &values, sizeof values);
}

}  // namespace beadswim
