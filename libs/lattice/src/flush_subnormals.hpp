#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace beadswim {

/// While it lives, numbers too small for the format's full digits become zero. Ahead of the first waves in a
/// fluid at rest populations fall by an order of magnitude a cell, below what single precision can hold, and
/// processors handle such numbers much more slowly.
class FlushSubnormals {
 public:
#if defined(__SSE2__)
  FlushSubnormals() : before_(_mm_getcsr()) {
    constexpr unsigned flush_to_zero = 0x8000, subnormals_are_zero = 0x0040;
    _mm_setcsr(before_ | flush_to_zero | subnormals_are_zero);
  }
  ~FlushSubnormals() {
    _mm_setcsr(before_);
  }
#else
  FlushSubnormals() {}
  ~FlushSubnormals() {}
#endif
  FlushSubnormals(const FlushSubnormals&) = delete;
  FlushSubnormals& operator=(const FlushSubnormals&) = delete;

 private:
#if defined(__SSE2__)
  unsigned before_;
#endif
};

}  // namespace beadswim
