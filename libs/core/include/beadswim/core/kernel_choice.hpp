#pragma once

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

}  // namespace beadswim
