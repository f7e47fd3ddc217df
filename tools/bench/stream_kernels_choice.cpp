#include "stream_kernels.hpp"

namespace beadswim {
namespace {

#define BEADSWIM_STREAM_KERNELS(set)                                           \
  StreamKernels {                                                              \
    set::stream_row_fp64, set::stream_row_fp32, set::copy, set::scale_in_place \
  }

StreamKernels choose() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("x86-64-v4")) return BEADSWIM_STREAM_KERNELS(x86_64_v4);
  if (__builtin_cpu_supports("x86-64-v3")) return BEADSWIM_STREAM_KERNELS(x86_64_v3);
#endif
  return BEADSWIM_STREAM_KERNELS(baseline);
}

}  // namespace

const StreamKernels& stream_kernels() {
  static const StreamKernels chosen = choose();
  return chosen;
}

}  // namespace beadswim
