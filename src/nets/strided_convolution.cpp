#include "nets/strided_convolution.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/vector.hpp"
#include "nets/matrix_product.hpp"

namespace piae::nets {

namespace {

/// Returns the shapes of input and output.
template <class T>
std::pair<SequenceShape, SequenceShape> sides_of(GradientArray<T>& parameters,
                                                 const std::string& name, ConvolutionKind kind,
                                                 std::int64_t input_length) {
  const ParameterSpec weight = parameters.spec(name + "/weight");
  const std::int64_t stride = weight.shape.size() == 3 ? weight.shape[2] / 2 : 0;
  if (stride < 2 || stride % 2 != 0 || weight.shape[2] != 2 * stride ||
      weight.shape[0] % row_granule != 0) {
    throw std::logic_error(weight.name + " is not the weight of a strided convolution");
  }
  if (kind == ConvolutionKind::transposed) {
    return {{.length = input_length, .width = weight.shape[0]},
            {.length = input_length * stride, .width = weight.shape[1]}};
  }
  if (input_length % stride != 0) {
    throw std::logic_error(weight.name + ": its stride does not divide the length");
  }
  return {{.length = input_length, .width = weight.shape[1]},
          {.length = input_length / stride, .width = weight.shape[0]}};
}

}  // namespace

template <class T>
StridedConvolution<T>::StridedConvolution(GradientArray<T>& parameters, const std::string& name,
                                          ConvolutionKind kind, std::int64_t input_length)
    : SequenceLayer<T>(sides_of(parameters, name, kind, input_length)),
      kind_(kind),
      weight_(parameters.find(name + "/weight")),
      bias_(parameters.find(name + "/bias")) {
  const std::int64_t held_columns = whole_rows(stride() * fine().width);
  to_coarse_ = packed_gradient_ = Numbers::Zero(under_kernel() * coarse().width);
  to_fine_ = Numbers::Zero(2 * coarse().width * held_columns);
  padded_coarse_ = Numbers::Zero(coarse().size() + 2 * coarse().width);
  made_fine_ = Numbers::Zero((coarse().length + 1) * held_columns);
}

template <class T>
void StridedConvolution<T>::renew_to_coarse() {
  for (std::int64_t o = 0; o < coarse().width; ++o) {
    const T* from = weight_.values + o * weight_.held_columns;
    for (std::int64_t c = 0; c < fine().width; ++c) {
      for (std::int64_t j = 0; j < 2 * stride(); ++j) {
        to_coarse_[(j * fine().width + c) * coarse().width + o] = *from++;
      }
    }
  }
}

template <class T>
void StridedConvolution<T>::renew_to_fine() {
  const std::int64_t held_columns = whole_rows(stride() * fine().width);
  for (std::int64_t o = 0; o < coarse().width; ++o) {
    const T* from = weight_.values + o * weight_.held_columns;
    for (std::int64_t c = 0; c < fine().width; ++c) {
      for (std::int64_t j = 0; j < 2 * stride(); ++j) {
        const std::int64_t row = (j < stride() ? coarse().width : 0) + o;
        to_fine_[row * held_columns + j % stride() * fine().width + c] = *from++;
      }
    }
  }
}

template <class T>
Rows<const T> StridedConvolution<T>::pad_fine(std::int64_t windows, const T* fine_side) {
  const std::int64_t size = fine().size();
  const Rows<T> padded{room_for(windows * (size + 2 * padding()), padded_fine_),
                       size + 2 * padding()};
  for (std::int64_t w = 0; w < windows; ++w) {
    T* const row = padded.row(w);
    std::fill_n(row, padding(), T{0});
    std::copy_n(fine_side + w * size, size, row + padding());
    std::fill_n(row + padding() + size, padding(), T{0});
  }
  return padded;
}

// The numbers under the kernel are contiguous, and those of neighbouring positions overlap. So each
// function below is a product of matrices.

template <class T>
void StridedConvolution<T>::make_coarse(std::int64_t windows, Rows<const T> padded_fine,
                                        T* coarse_side) const {
  for (std::int64_t w = 0; w < windows; ++w) {
    multiply<T>({.a = padded_fine.row(w),
                 .a_row = stride() * fine().width,
                 .a_column = 1,
                 .b = to_coarse_.data(),
                 .b_row = coarse().width,
                 .c = coarse_side + w * coarse().size(),
                 .c_row = coarse().width,
                 .rows = coarse().length,
                 .columns = coarse().width,
                 .depth = under_kernel()});
  }
}

template <class T>
void StridedConvolution<T>::make_fine(std::int64_t windows, const T* coarse_side, T* fine_side) {
  // A row of the product is `stride` fine positions, counted from the first position of padding.
  // The second half of the kernel reaches them from one coarse position, the first half from the
  // next.
  const std::int64_t columns = stride() * fine().width;
  const std::int64_t held_columns = whole_rows(columns);
  const std::int64_t size = fine().size();
  for (std::int64_t w = 0; w < windows; ++w) {
    std::copy_n(coarse_side + w * coarse().size(), coarse().size(),
                padded_coarse_.data() + coarse().width);
    multiply<T>({.a = padded_coarse_.data(),
                 .a_row = coarse().width,
                 .a_column = 1,
                 .b = to_fine_.data(),
                 .b_row = held_columns,
                 .c = made_fine_.data(),
                 .c_row = held_columns,
                 .rows = coarse().length + 1,
                 .columns = held_columns,
                 .depth = 2 * coarse().width});
    T* to = fine_side + w * size;
    const T* const made = made_fine_.data();
    to = std::copy(made + padding(), made + columns, to);
    for (std::int64_t i = 1; i < coarse().length; ++i) {
      to = std::copy_n(made + i * held_columns, columns, to);
    }
    std::copy_n(made + coarse().length * held_columns, columns - padding(), to);
  }
}

template <class T>
void StridedConvolution<T>::differentiate_weight(std::int64_t windows, Rows<const T> padded_fine,
                                                 const T* coarse_side) {
  multiply<T>({.a = padded_fine.data,
               .a_row = 1,
               .a_column = stride() * fine().width,
               .b = coarse_side,
               .b_row = coarse().width,
               .c = packed_gradient_.data(),
               .c_row = coarse().width,
               .rows = under_kernel(),
               .columns = coarse().width,
               .depth = coarse().length,
               .blocks = windows,
               .a_block = padded_fine.stride,
               .b_block = coarse().size()});
  for (std::int64_t o = 0; o < coarse().width; ++o) {
    T* to = weight_.gradient + o * weight_.held_columns;
    for (std::int64_t c = 0; c < fine().width; ++c) {
      for (std::int64_t j = 0; j < 2 * stride(); ++j) {
        *to++ = packed_gradient_[(j * fine().width + c) * coarse().width + o];
      }
    }
  }
}

template <class T>
void StridedConvolution<T>::forward(std::int64_t windows, const T* x, T* y) {
  if (kind_ == ConvolutionKind::strided) {
    renew_to_coarse();
    make_coarse(windows, pad_fine(windows, x), y);
  } else {
    renew_to_fine();
    make_fine(windows, x, y);
  }
  add_bias(bias_, windows * this->output().length, this->output().width, y);
}

template <class T>
void StridedConvolution<T>::backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) {
  differentiate_bias(bias_, batch.windows * this->output().length, this->output().width, dy);
  if (kind_ == ConvolutionKind::strided) {
    differentiate_weight(batch.windows, {padded_fine_.data(), fine().size() + 2 * padding()}, dy);
    if (dx == nullptr) return;
    renew_to_fine();
    make_fine(batch.all(), dy, dx);
  } else {
    const Rows<const T> padded = pad_fine(dx == nullptr ? batch.windows : batch.all(), dy);
    differentiate_weight(batch.windows, padded, x);
    if (dx == nullptr) return;
    renew_to_coarse();
    make_coarse(batch.all(), padded, dx);
  }
}

template class StridedConvolution<float>;
template class StridedConvolution<double>;

}  // namespace piae::nets
