#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "nets/gradient_array.hpp"
#include "nets/sequence_layer.hpp"
#include "nets/weight_products.hpp"

namespace piae::nets {

/// A convolution along time whose taps are `dilation` positions apart, with zeros beyond both ends.
/// The number of positions stays the same: y_t = b + sum over k of W_k x_(t + (k - (kernel - 1) /
/// 2) dilation). The kernel has an odd number of taps.
struct DilatedTaps {
  std::int64_t kernel;
  std::int64_t dilation;
};

/// Returns <name>/weight [outputs, kernel, inputs], which keeps the inputs of a tap contiguous, and
/// <name>/bias [outputs].
std::vector<ParameterSpec> dilated_convolution_specs(const std::string& name, std::int64_t inputs,
                                                     std::int64_t outputs, std::int64_t kernel);

/// Copies the inputs of all taps next to each other, so that one large product does the work.
template <class T>
class DilatedConvolution final : public SequenceLayer<T> {
 public:
  /// Both widths must be whole rows.
  DilatedConvolution(GradientArray<T>& parameters, const std::string& name, std::int64_t length,
                     const DilatedTaps& taps);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  /// Returns the distance from a position to a tap's input.
  [[nodiscard]] std::int64_t offset(std::int64_t tap) const {
    return (tap - taps_.kernel / 2) * taps_.dilation;
  }
  /// Returns the number of inputs of all taps at a position.
  [[nodiscard]] std::int64_t row_of_taps() const { return taps_.kernel * this->input().width; }
  /// Collects the inputs of all taps of a window, [length, kernel * inputs].
  void gather(const T* x, T* read) const;
  /// Converts the gradient by the taps' inputs to that by the window.
  void scatter(const T* read, T* x) const;

  DilatedTaps taps_;
  WeightProducts<T> products_;
  TrainedParameter<T> bias_;
  Eigen::ArrayX<T> read_;           ///< [windows, length, kernel * inputs]
  Eigen::ArrayX<T> read_gradient_;  ///< for one window
};

extern template class DilatedConvolution<float>;
extern template class DilatedConvolution<double>;

}  // namespace piae::nets
