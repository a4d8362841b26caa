#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace piae {

// The processor's vector registers, by GCC's vector extension: arithmetic and comparisons work
// element by element. Which registers there are is known from -march.

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

/// How many numbers a vector holds.
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

/// Fast only in a file that is compiled with -fno-math-errno (see CMakeLists.txt); elsewhere the
/// compiler calls a function for each number.
template <class T>
Vector<T> square_root(Vector<T> x) {
  T roots[lanes<T>];
  store<T>(roots, x);
  for (T& root : roots) root = std::sqrt(root);
  return load(roots);
}

/// Rows of numbers are filled up with zeros to a multiple of this. So they consist of whole vectors
/// on every processor, and have the same layout on all of them.
inline constexpr std::int64_t row_granule = 16;
static_assert(row_granule % lanes<float> == 0 && row_granule % lanes<double> == 0);

/// The length of a row of n numbers once it is filled up.
constexpr std::int64_t whole_rows(std::int64_t n) {
  return (n + row_granule - 1) / row_granule * row_granule;
}

}  // namespace piae
