#pragma once

// Instruction sets for which kernels are compiled (beadswim_kernels in cmake/BeadswimTargets.cmake), and
// their selection at run time.

namespace beadswim::instruction_set_name {

constexpr const char *baseline = "baseline", *x86_64_v3 = "x86-64-v3", *x86_64_v4 = "x86-64-v4";

}  // namespace beadswim::instruction_set_name

/// Evaluates kernels_of(instruction_set) for the best instruction set that this processor supports.
/// `kernels_of` is a macro whose argument is baseline, x86_64_v3 or x86_64_v4.
/// BEADSWIM_ALL_INSTRUCTION_SETS is defined by the build if the kernels are compiled for all three (BeadswimTargets.cmake).
#ifdef BEADSWIM_ALL_INSTRUCTION_SETS
#define BEADSWIM_BEST_KERNELS(kernels_of)                        \
  (__builtin_cpu_supports("x86-64-v4")   ? kernels_of(x86_64_v4) \
   : __builtin_cpu_supports("x86-64-v3") ? kernels_of(x86_64_v3) \
                                         : kernels_of(baseline))
#else
#define BEADSWIM_BEST_KERNELS(kernels_of) (kernels_of(baseline))
#endif
