#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace piae {

/// While an object lives, its thread treats denormal numbers (below 1e-38 in single precision) as
/// zero, both inputs and results. Operations on them take a hundred times as long. Does nothing on
/// processors without SSE.
class DenormalsAreZero {
 public:
#if defined(__SSE__)
  DenormalsAreZero() : before_(_mm_getcsr()) {
    constexpr unsigned computed = 1U << 15;  // "flush to zero"
    constexpr unsigned read = 1U << 6;       // "denormals are zeros"
    _mm_setcsr(before_ | computed | read);
  }
  ~DenormalsAreZero() { _mm_setcsr(before_); }
#else
  DenormalsAreZero() {}
  ~DenormalsAreZero() {}
#endif
  DenormalsAreZero(const DenormalsAreZero&) = delete;
  DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

 private:
#if defined(__SSE__)
  unsigned before_;
#endif
};

}  // namespace piae
