#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace piae {

// The processor's vector registers, by GCC's vector extension: arithmetic is element by element,
// and a comparison chooses element by element. What the processor has is known from -march.

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

/// Numbers in a vector.
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

/// Needs -fno-math-errno for the file, or else it is a call for each lane (see CMakeLists.txt).
template <class T>
Vector<T> square_root(Vector<T> x) {
  T roots[lanes<T>];
  store<T>(roots, x);
  for (T& root : roots) root = std::sqrt(root);
  return load(roots);
}

/// Rows of numbers are filled up with zeros to a multiple of this, so that they are whole vectors
/// on every processor, and laid out the same.
inline constexpr std::int64_t row_granule = 16;
static_assert(row_granule % lanes<float> == 0 && row_granule % lanes<double> == 0);

constexpr std::int64_t whole_rows(std::int64_t n) {
  return (n + row_granule - 1) / row_granule * row_granule;
}

}  // namespace piae
