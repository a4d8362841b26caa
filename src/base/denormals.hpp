#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace piae {

/// As long as it lives, the arithmetic of this thread takes numbers that are too small to be
/// written with all their digits ("denormal": below 1e-38 in single precision) for zeros. Intel's
/// cores hand each vector that has one to microcode, which takes a hundred times as long. Adam's
/// moments are full of them: the gradient of a unit that gives nothing is 0, so its first moment
/// shrinks by a tenth a step, for ever. No weight changes by it. Processors other than x86 do
/// without.
class FlushDenormals {
 public:
#if defined(__SSE__)
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | results_and_inputs); }
  ~FlushDenormals() { _mm_setcsr(before_); }
#else
  FlushDenormals() = default;
  ~FlushDenormals() = default;
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

#if defined(__SSE__)
 private:
  static constexpr unsigned results_and_inputs = 0x8040;
  unsigned before_;
#endif
};

}  // namespace piae
