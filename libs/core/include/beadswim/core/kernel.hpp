#pragma once

/// Always inlined: kernels are compiled from one source for several instruction sets (beadswim_kernels in
/// cmake/BeadswimTargets.cmake), and no copy of what they call may be shared between these.
#define BEADSWIM_KERNEL inline __attribute__((always_inline))
