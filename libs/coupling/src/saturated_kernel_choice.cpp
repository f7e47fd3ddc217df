#include "saturated_kernel.hpp"

namespace beadswim {
namespace {

SaturatedKernels choose() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("x86-64-v4")) return {x86_64_v4::push_cells, x86_64_v4::push_cells};
  if (__builtin_cpu_supports("x86-64-v3")) return {x86_64_v3::push_cells, x86_64_v3::push_cells};
#endif
  return {baseline::push_cells, baseline::push_cells};
}

}  // namespace

const SaturatedKernels& saturated_kernels() {
  static const SaturatedKernels chosen = choose();
  return chosen;
}

}  // namespace beadswim
