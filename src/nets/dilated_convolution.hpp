#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "nets/gradient_array.hpp"
#include "nets/sequence_layer.hpp"
#include "nets/weight_products.hpp"

namespace piae::nets {

/// A convolution along time whose taps lie `dilation` positions apart, with zeros beyond both ends,
/// so that as many positions come out as go in: y_t = b + sum over k of W_k x_(t + (k - (kernel -
/// 1) / 2) dilation). The kernel has an odd number of taps.
struct DilatedTaps {
  std::int64_t kernel;
  std::int64_t dilation;
};

/// <name>/weight [outputs, kernel, inputs], so that what a tap reads lies side by side, and
/// <name>/bias [outputs].
std::vector<ParameterSpec> dilated_convolution_specs(const std::string& name, std::int64_t inputs,
                                                     std::int64_t outputs, std::int64_t kernel);

/// What all taps read is copied side by side, so that one large product does the work.
template <class T>
class DilatedConvolution final : public SequenceLayer<T> {
 public:
  /// Both widths must be whole rows.
  DilatedConvolution(GradientArray<T>& parameters, const std::string& name, std::int64_t length,
                     const DilatedTaps& taps);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  /// How far from its position a tap reads.
  [[nodiscard]] std::int64_t offset(std::int64_t tap) const {
    return (tap - taps_.kernel / 2) * taps_.dilation;
  }
  /// How many numbers the taps read at a position.
  [[nodiscard]] std::int64_t row_of_taps() const { return taps_.kernel * this->input().width; }
  /// What the taps read of a window, [length, kernel * inputs].
  void gather(const T* x, T* read) const;
  /// From the gradient by what the taps read to that by the window.
  void scatter(const T* read, T* x) const;

  DilatedTaps taps_;
  WeightProducts<T> products_;
  TrainedParameter<T> bias_;
  Eigen::ArrayX<T> read_;           ///< [windows, length, kernel * inputs]
  Eigen::ArrayX<T> read_gradient_;  ///< of one window
};

extern template class DilatedConvolution<float>;
extern template class DilatedConvolution<double>;

}  // namespace piae::nets
