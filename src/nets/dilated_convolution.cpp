#include "nets/dilated_convolution.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/vector.hpp"

namespace piae::nets {

std::vector<ParameterSpec> dilated_convolution_specs(const std::string& name, std::int64_t inputs,
                                                     std::int64_t outputs, std::int64_t kernel) {
  const double bound = 1 / std::sqrt(static_cast<double>(kernel * inputs));
  return {{name + "/weight", {outputs, kernel, inputs}, bound}, {name + "/bias", {outputs}, bound}};
}

template <class T>
DilatedConvolution<T>::DilatedConvolution(GradientArray<T>& parameters, const std::string& name,
                                          std::int64_t length, const DilatedTaps& taps)
    : SequenceLayer<T>(
          {.length = length, .width = parameters.find(name + "/weight").columns / taps.kernel},
          {.length = length, .width = parameters.find(name + "/weight").rows}),
      taps_(taps),
      products_(parameters.find(name + "/weight")),
      bias_(parameters.find(name + "/bias")) {
  const std::int64_t inputs = this->input().width;
  const std::int64_t outputs = this->output().width;
  if (inputs != whole_rows(inputs) || outputs != whole_rows(outputs)) {
    throw std::logic_error("the channels of " + name + " do not fill whole rows");
  }
  read_gradient_.resize(length * row_of_taps());
}

template <class T>
void DilatedConvolution<T>::gather(const T* x, T* read) const {
  const std::int64_t length = this->input().length;
  const std::int64_t inputs = this->input().width;
  for (std::int64_t t = 0; t < length; ++t) {
    for (std::int64_t k = 0; k < taps_.kernel; ++k, read += inputs) {
      const std::int64_t at = t + offset(k);
      if (at >= 0 && at < length) {
        std::copy_n(x + at * inputs, inputs, read);
      } else {
        std::fill_n(read, inputs, T{0});
      }
    }
  }
}

template <class T>
void DilatedConvolution<T>::scatter(const T* read, T* x) const {
  const std::int64_t length = this->input().length;
  const std::int64_t inputs = this->input().width;
  const std::int64_t middle = taps_.kernel / 2;  // offset 0
  for (std::int64_t at = 0; at < length; ++at, x += inputs) {
    std::copy_n(read + (at * taps_.kernel + middle) * inputs, inputs, x);
    for (std::int64_t k = 0; k < taps_.kernel; ++k) {
      const std::int64_t t = at - offset(k);
      if (k == middle || t < 0 || t >= length) continue;
      as_matrix(x, 1, inputs) += as_matrix(read + (t * taps_.kernel + k) * inputs, 1, inputs);
    }
  }
}

template <class T>
void DilatedConvolution<T>::forward(std::int64_t windows, const T* x, T* y) {
  const std::int64_t rows = windows * this->input().length;
  T* const read = room_for(rows * row_of_taps(), read_);
  for (std::int64_t w = 0; w < windows; ++w) {
    gather(x + w * this->input().size(), read + w * this->input().length * row_of_taps());
  }
  const std::int64_t outputs = this->output().width;
  products_.renew();
  products_.forward(rows, {read, row_of_taps()}, {y, outputs});
  add_bias(bias_, rows, outputs, y);
}

template <class T>
void DilatedConvolution<T>::backward(const SignalBatch& batch, const T*, const T* dy, T* dx) {
  const std::int64_t length = this->input().length;
  const std::int64_t outputs = this->output().width;
  const std::int64_t rows = batch.windows * length;
  products_.differentiate(rows, {read_.data(), row_of_taps()}, {dy, outputs});
  differentiate_bias(bias_, rows, outputs, dy);
  if (dx == nullptr) return;
  for (std::int64_t w = 0; w < batch.all(); ++w) {
    products_.backward(length, {dy + w * this->output().size(), outputs},
                       {read_gradient_.data(), row_of_taps()});
    scatter(read_gradient_.data(), dx + w * this->input().size());
  }
}

template class DilatedConvolution<float>;
template class DilatedConvolution<double>;

}  // namespace piae::nets
