#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace piae {

// The processor's vector registers, by GCC's vector extension: arithmetic and comparisons work
// element by element. -march decides which registers exist.

#if defined(__AVX512F__)
inline constexpr std::size_t vector_bytes = 64;
inline constexpr int vector_registers = 32;
#elif defined(__AVX__)
inline constexpr std::size_t vector_bytes = 32;
inline constexpr int vector_registers = 16;
#else
inline constexpr std::size_t vector_bytes = 16;
inline constexpr int vector_registers = 16;
#endif

template <class T>
struct VectorOf {
  typedef T type __attribute__((vector_size(vector_bytes)));
};
template <class T>
using Vector = typename VectorOf<T>::type;

/// Count of numbers in a vector.
template <class T>
inline constexpr std::int64_t lanes = vector_bytes / sizeof(T);

template <class T>
Vector<T> load(const T* from) {
  Vector<T> vector;
  std::memcpy(&vector, from, sizeof vector);
  return vector;
}

template <class T>
void store(T* to, Vector<T> vector) {
  std::memcpy(to, &vector, sizeof vector);
}

/// Returns the square roots. Fast only in files compiled with -fno-math-errno (see CMakeLists.txt);
/// elsewhere the compiler may call a function for each number.
template <class T>
Vector<T> square_root(Vector<T> x) {
#if defined(__AVX512F__)
  // GCC would compute two halves, join them in memory and wait for the result.
  if constexpr (std::is_same_v<T, float>) return _mm512_sqrt_ps(x);
#endif
  T roots[lanes<T>];
  store<T>(roots, x);
  for (T& root : roots) root = std::sqrt(root);
  return load(roots);
}

#if defined(__AVX512F__)
/// Computes positive_root() three times as fast as the processor's instruction, with the same
/// rounding. Two rounds of Goldschmidt's method refine the estimates of 1 / sqrt(x) and sqrt(x)
/// together, until only the last bits are wrong. The exact remainder of x, by a fused
/// multiplication, then corrects the root.
inline Vector<double> root_by_estimate(Vector<double> x) {
  const Vector<double> half = Vector<double>{} + 0.5;
  const __mmask8 positive = _mm512_cmp_pd_mask(x, Vector<double>{}, _CMP_GT_OQ);
  const Vector<double> inverse = _mm512_maskz_rsqrt14_pd(positive, x);
  Vector<double> root = x * inverse;
  Vector<double> half_inverse = half * inverse;
  for (int round = 0; round < 2; ++round) {
    const Vector<double> missing = _mm512_fnmadd_pd(root, half_inverse, half);
    root = _mm512_fmadd_pd(root, missing, root);
    half_inverse = _mm512_fmadd_pd(half_inverse, missing, half_inverse);
  }
  const Vector<double> rest = _mm512_fnmadd_pd(root, root, x);
  return _mm512_fmadd_pd(rest, half_inverse, root);
}
#endif

/// Returns the square roots of finite numbers; 0 for numbers that are not positive. Results for
/// infinity and NaN depend on the processor.
inline Vector<double> positive_root(Vector<double> x) {
#if defined(__AVX512F__)
  return root_by_estimate(x);
#else
  return square_root<double>(x > 0 ? x : Vector<double>{});
#endif
}

/// True if any number of a vector is above zero.
inline bool any_positive(Vector<double> x) {
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask(x, Vector<double>{}, _CMP_GT_OQ) != 0;
#elif defined(__AVX__)
  return _mm256_movemask_pd(_mm256_cmp_pd(x, Vector<double>{}, _CMP_GT_OQ)) != 0;
#else
  bool any = false;
  for (std::int64_t i = 0; i < lanes<double>; ++i) any = any || x[i] > 0;
  return any;
#endif
}

/// Rows of numbers are padded with zeros to a multiple of this length. So they consist of whole
/// vectors, and have the same layout on every processor.
inline constexpr std::int64_t row_granule = 16;
static_assert(row_granule % lanes<float> == 0 && row_granule % lanes<double> == 0);

/// Returns the padded length of a row of n numbers.
constexpr std::int64_t whole_rows(std::int64_t n) {
  return (n + row_granule - 1) / row_granule * row_granule;
}

}  // namespace piae
