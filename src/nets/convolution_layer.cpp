#include "nets/convolution_layer.hpp"

#include <stdexcept>
#include <utility>

#include "base/vector.hpp"

namespace piae::nets {

namespace {

/// The signals of a row, [time, channel].
template <class T>
using Signal = Eigen::Map<Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
template <class T>
using ConstSignal =
    Eigen::Map<const Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

StridedConvolution shape_of(const ParameterSpec& weight, ConvolutionKind kind,
                            std::int64_t input_length) {
  const std::int64_t stride = weight.shape.size() == 3 ? weight.shape[2] / 2 : 0;
  if (stride < 2 || stride % 2 != 0 || weight.shape[2] != 2 * stride ||
      weight.shape[0] % row_granule != 0) {
    throw std::logic_error(weight.name + " is not that of a strided convolution");
  }
  if (kind == ConvolutionKind::strided && input_length % stride != 0) {
    throw std::logic_error(weight.name + ": its stride does not divide the length");
  }
  return {.fine_channels = weight.shape[1],
          .coarse_channels = weight.shape[0],
          .stride = stride,
          .coarse_length = kind == ConvolutionKind::strided ? input_length / stride : input_length};
}

}  // namespace

template <class T>
ConvolutionLayer<T>::ConvolutionLayer(std::shared_ptr<Parameters<T>> parameters,
                                      const std::string& name, ConvolutionKind kind,
                                      std::int64_t input_length)
    : parameters_(std::move(parameters)), kind_(kind) {
  const auto& weight = parameters_->find(name + "/weight");
  const auto& bias = parameters_->find(name + "/bias");
  shape_ = shape_of(weight.spec, kind, input_length);
  weight_begin_ = weight.begin;
  bias_begin_ = bias.begin;
  held_columns_ = weight.held_columns;
  gradient_by_weight_ = Numbers::Zero(weight.rows * weight.held_columns);
  gradient_by_bias_ = Numbers::Zero(bias.held_columns);
}

template <class T>
std::int64_t ConvolutionLayer<T>::output_length() const {
  return kind_ == ConvolutionKind::strided ? shape_.coarse_length : shape_.fine_length();
}

template <class T>
std::int64_t ConvolutionLayer<T>::inputs() const {
  return kind_ == ConvolutionKind::strided ? shape_.fine_channels : shape_.coarse_channels;
}

template <class T>
std::int64_t ConvolutionLayer<T>::outputs() const {
  return kind_ == ConvolutionKind::strided ? shape_.coarse_channels : shape_.fine_channels;
}

template <class T>
void ConvolutionLayer<T>::forward(std::int64_t rows, Rows<const T> input, Rows<T> output) const {
  if (kind_ == ConvolutionKind::strided) {
    convolve(shape_, rows, input, weight(), output);
  } else {
    convolve_transposed(shape_, rows, input, weight(), output);
  }
  const Eigen::Map<const Numbers> bias(parameters_->data(Kept::value) + bias_begin_, outputs());
  for (std::int64_t r = 0; r < rows; ++r) {
    Signal<T>(output.row(r), output_length(), outputs()).rowwise() += bias.transpose();
  }
}

template <class T>
void ConvolutionLayer<T>::propagate_back(std::int64_t rows, Rows<const T> output_gradient,
                                         Rows<T> input_gradient) const {
  if (kind_ == ConvolutionKind::strided) {
    convolve_transposed(shape_, rows, output_gradient, weight(), input_gradient);
  } else {
    convolve(shape_, rows, output_gradient, weight(), input_gradient);
  }
}

template <class T>
void ConvolutionLayer<T>::differentiate(std::int64_t rows, Rows<const T> input,
                                        Rows<const T> output_gradient) {
  const Rows<T> to{gradient_by_weight_.data(), held_columns_};
  if (kind_ == ConvolutionKind::strided) {
    weight_gradient(shape_, rows, input, output_gradient, to);
  } else {
    weight_gradient(shape_, rows, output_gradient, input, to);
  }
  auto by_bias = gradient_by_bias_.head(outputs());
  by_bias.setZero();
  for (std::int64_t r = 0; r < rows; ++r) {
    by_bias += ConstSignal<T>(output_gradient.row(r), output_length(), outputs())
                   .colwise()
                   .sum()
                   .transpose();
  }
}

template <class T>
double ConvolutionLayer<T>::squared_norm() const {
  return gradient_by_weight_.template cast<double>().square().sum() +
         gradient_by_bias_.template cast<double>().square().sum();
}

template <class T>
void ConvolutionLayer<T>::take(const AdamStep& step, double scale) {
  const auto follow = [&](std::int64_t begin, const Numbers& gradient) {
    const Numbers scaled = static_cast<T>(scale) * gradient;
    nets::take(step, parameters_->data(Kept::value) + begin, scaled.data(),
               parameters_->data(Kept::first_moment) + begin,
               parameters_->data(Kept::second_moment) + begin,
               static_cast<std::size_t>(scaled.size()));
  };
  follow(weight_begin_, gradient_by_weight_);
  follow(bias_begin_, gradient_by_bias_);
}

template class ConvolutionLayer<float>;
template class ConvolutionLayer<double>;

}  // namespace piae::nets
