#include "nets/strided_convolution.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/vector.hpp"
#include "nets/matrix_product.hpp"

namespace piae::nets {

namespace {

template <class T>
std::vector<T> numbers(std::int64_t size) {
  return std::vector<T>(static_cast<std::size_t>(size));
}

/// Calls f(o, c, j, w) with each number of a weight.
template <class T, class F>
void for_each_weight(const StridedConvolution& shape, Rows<T> weight, const F& f) {
  for (std::int64_t o = 0; o < shape.coarse_channels; ++o) {
    T* w = weight.row(o);
    for (std::int64_t c = 0; c < shape.fine_channels; ++c) {
      for (std::int64_t j = 0; j < shape.kernel(); ++j) f(o, c, j, *w++);
    }
  }
}

/// Where a weight stands in the matrix [tap, fine channel][coarse channel].
struct ByCoarse {
  const StridedConvolution& shape;

  std::int64_t operator()(std::int64_t o, std::int64_t c, std::int64_t j) const {
    return (j * shape.fine_channels + c) * shape.coarse_channels + o;
  }
};

}  // namespace

template <class T>
void convolve(const StridedConvolution& shape, std::int64_t rows, Rows<const T> fine,
              Rows<const T> weight, Rows<T> coarse) {
  const std::int64_t depth = shape.kernel() * shape.fine_channels;
  std::vector<T> packed = numbers<T>(depth * shape.coarse_channels);
  for_each_weight(shape, weight, [&, at = ByCoarse{shape}](auto o, auto c, auto j, T w) {
    packed[static_cast<std::size_t>(at(o, c, j))] = w;
  });
  for (std::int64_t r = 0; r < rows; ++r) {
    multiply<T>({.a = fine.row(r) - shape.padding() * shape.fine_channels,
                 .a_row = shape.stride * shape.fine_channels,
                 .a_column = 1,
                 .b = packed.data(),
                 .b_row = shape.coarse_channels,
                 .c = coarse.row(r),
                 .c_row = shape.coarse_channels,
                 .rows = shape.coarse_length,
                 .columns = shape.coarse_channels,
                 .depth = depth});
  }
}

template <class T>
void convolve_transposed(const StridedConvolution& shape, std::int64_t rows, Rows<const T> coarse,
                         Rows<const T> weight, Rows<T> fine) {
  // `stride` fine times, counted from the first one of the padding, are one row of the product: the
  // second half of the kernel reaches them from one coarse time, the first half from the next.
  const std::int64_t columns = shape.stride * shape.fine_channels;
  const std::int64_t held_columns = whole_rows(columns);
  std::vector<T> packed = numbers<T>(2 * shape.coarse_channels * held_columns);
  for_each_weight(shape, weight, [&](auto o, auto c, auto j, T w) {
    const std::int64_t row = (j < shape.stride ? shape.coarse_channels : 0) + o;
    const std::int64_t column = j % shape.stride * shape.fine_channels + c;
    packed[static_cast<std::size_t>(row * held_columns + column)] = w;
  });
  const std::int64_t product_rows = shape.coarse_length + 1;
  const std::int64_t padding = shape.padding() * shape.fine_channels;
  std::vector<T> held = numbers<T>(held_columns == columns ? 0 : product_rows * held_columns);
  for (std::int64_t r = 0; r < rows; ++r) {
    T* const to = fine.row(r) - padding;
    multiply<T>({.a = coarse.row(r) - shape.coarse_channels,
                 .a_row = shape.coarse_channels,
                 .a_column = 1,
                 .b = packed.data(),
                 .b_row = held_columns,
                 .c = held.empty() ? to : held.data(),
                 .c_row = held_columns,
                 .rows = product_rows,
                 .columns = held_columns,
                 .depth = 2 * shape.coarse_channels});
    if (!held.empty()) {
      for (std::int64_t i = 0; i < product_rows; ++i) {
        std::copy_n(held.data() + i * held_columns, columns, to + i * columns);
      }
    }
    std::fill_n(to, padding, T{0});
    std::fill_n(fine.row(r) + shape.fine_length() * shape.fine_channels, padding, T{0});
  }
}

template <class T>
void weight_gradient(const StridedConvolution& shape, std::int64_t rows, Rows<const T> fine,
                     Rows<const T> coarse, Rows<T> gradient) {
  const std::int64_t product_rows = shape.kernel() * shape.fine_channels;
  std::vector<T> packed = numbers<T>(product_rows * shape.coarse_channels);
  multiply<T>({.a = fine.data - shape.padding() * shape.fine_channels,
               .a_row = 1,
               .a_column = shape.stride * shape.fine_channels,
               .b = coarse.data,
               .b_row = shape.coarse_channels,
               .c = packed.data(),
               .c_row = shape.coarse_channels,
               .rows = product_rows,
               .columns = shape.coarse_channels,
               .depth = shape.coarse_length,
               .blocks = rows,
               .a_block = fine.stride,
               .b_block = coarse.stride});
  for_each_weight(shape, gradient, [&, at = ByCoarse{shape}](auto o, auto c, auto j, T& w) {
    w = packed[static_cast<std::size_t>(at(o, c, j))];
  });
}

#define PIAE_INSTANTIATE_CONVOLUTION(T)                                                         \
  template void convolve(const StridedConvolution&, std::int64_t, Rows<const T>, Rows<const T>, \
                         Rows<T>);                                                              \
  template void convolve_transposed(const StridedConvolution&, std::int64_t, Rows<const T>,     \
                                    Rows<const T>, Rows<T>);                                    \
  template void weight_gradient(const StridedConvolution&, std::int64_t, Rows<const T>,         \
                                Rows<const T>, Rows<T>)
PIAE_INSTANTIATE_CONVOLUTION(float);
PIAE_INSTANTIATE_CONVOLUTION(double);

}  // namespace piae::nets
