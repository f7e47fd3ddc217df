#pragma once

/// Marks a function that is always inlined. Kernels are compiled from one source for several instruction sets
/// (beadswim_kernels in cmake/BeadswimTargets.cmake). Inlining prevents the linker from sharing one compiled
/// function between kernels of different instruction sets.
#define BEADSWIM_KERNEL inline __attribute__((always_inline))

namespace beadswim {

/// Returns the kernels of the best instruction set that this processor supports. `Kernels`: a struct of
/// pointers to kernels with the static members baseline, x86_64_v3 and x86_64_v4. The source file of the
/// kernels, which is compiled once per instruction set (beadswim_kernels in cmake/BeadswimTargets.cmake),
/// defines one of them: Kernels::BEADSWIM_INSTRUCTION_SET. BEADSWIM_ALL_INSTRUCTION_SETS is defined if it is
/// compiled for all three.
template <class Kernels>
const Kernels& best_kernels() {
#ifdef BEADSWIM_ALL_INSTRUCTION_SETS
  static const Kernels& best = __builtin_cpu_supports("x86-64-v4")   ? Kernels::x86_64_v4
                               : __builtin_cpu_supports("x86-64-v3") ? Kernels::x86_64_v3
                                                                     : Kernels::baseline;
  return best;
#else
  return Kernels::baseline;
#endif
}

// Vectors of numbers: kernels process one cell, link or pair of spheres in each lane.

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
