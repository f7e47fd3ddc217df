#include "link_kernel.hpp"

namespace beadswim {
namespace {

LinkKernels choose() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("x86-64-v4")) return {x86_64_v4::reflect_fp64, x86_64_v4::reflect_fp32};
  if (__builtin_cpu_supports("x86-64-v3")) return {x86_64_v3::reflect_fp64, x86_64_v3::reflect_fp32};
#endif
  return {baseline::reflect_fp64, baseline::reflect_fp32};
}

}  // namespace

const LinkKernels& link_kernels() {
  static const LinkKernels chosen = choose();
  return chosen;
}

}  // namespace beadswim
