#include "link_kernel.hpp"

namespace beadswim {
namespace {

LinkKernels choose() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("x86-64-v4")) return BEADSWIM_LINK_KERNELS(x86_64_v4);
  if (__builtin_cpu_supports("x86-64-v3")) return BEADSWIM_LINK_KERNELS(x86_64_v3);
#endif
  return BEADSWIM_LINK_KERNELS(baseline);
}

}  // namespace

const LinkKernels& link_kernels() {
  static const LinkKernels chosen = choose();
  return chosen;
}

}  // namespace beadswim
