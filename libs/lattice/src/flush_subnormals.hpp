#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace beadswim {

/// Rounds subnormal numbers to zero during the lifetime of the object. Ahead of the first waves in a fluid at
/// rest, populations decrease by an order of magnitude per cell and become subnormal in single precision.
/// Processors evaluate subnormal numbers much more slowly.
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
