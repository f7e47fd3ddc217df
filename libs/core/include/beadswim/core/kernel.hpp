#pragma once

/// Marks a function that is always inlined. Kernels are compiled from one source for several instruction sets
/// (beadswim_kernels in cmake/BeadswimTargets.cmake). Inlining prevents the linker from sharing one compiled
/// function between kernels of different instruction sets.
#define BEADSWIM_KERNEL inline __attribute__((always_inline))
