#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace beadswim {

/// Rounds subnormal numbers to zero during the lifetime of the object, because processors evaluate them much
/// more slowly than other numbers. In single precision they occur while the first waves spread into fluid at
/// rest: ahead of these waves, populations decrease by an order of magnitude per cell.
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
