#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "nets/gradient_array.hpp"
#include "nets/sequence_layer.hpp"
#include "nets/weight_products.hpp"

namespace piae::nets {

enum class ConvolutionKind {
  strided,    ///< the output is the coarse side
  transposed  ///< the output is the fine side
};

/// A convolution with a stride along time, between a fine side and a coarse side. The coarse side
/// has one position per `stride` fine ones:
///
///   coarse[t][o] = b[o] + sum over taps j and fine channels c of
///                  fine[stride t - stride / 2 + j][c] weight[o][c][j]
///
/// Inputs outside the fine side are zero. The kernel is two strides wide, and half a stride of
/// zeros pads either end, so that lengths divide exactly.
///
/// A transposed convolution goes the other way: its output is a convolution's gradient by its
/// input, plus a bias. It has the same weight [coarse channels, fine channels, kernel],
/// <name>/weight. <name>/bias has one number per output channel.
///
/// The fine side may have any number of channels, such as the single channel of a recording.
template <class T>
class StridedConvolution final : public SequenceLayer<T> {
 public:
  /// Throws std::logic_error if the weight has another form, the stride is odd, the coarse channels
  /// are not whole rows, or the stride does not divide the length.
  StridedConvolution(GradientArray<T>& parameters, const std::string& name, ConvolutionKind kind,
                     std::int64_t input_length);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  using Numbers = Eigen::ArrayX<T>;

  [[nodiscard]] const SequenceShape& fine() const {
    return kind_ == ConvolutionKind::strided ? this->input() : this->output();
  }
  [[nodiscard]] const SequenceShape& coarse() const {
    return kind_ == ConvolutionKind::strided ? this->output() : this->input();
  }
  [[nodiscard]] std::int64_t stride() const { return fine().length / coarse().length; }
  /// Returns how many zeros pad either end of the fine side.
  [[nodiscard]] std::int64_t padding() const { return stride() / 2 * fine().width; }
  /// Returns the number of inputs under the kernel: two strides of the fine side.
  [[nodiscard]] std::int64_t under_kernel() const { return 2 * stride() * fine().width; }

  /// Copy the current weight into each of its two orders.
  void renew_to_coarse();
  void renew_to_fine();
  void make_coarse(std::int64_t windows, Rows<const T> padded_fine, T* coarse) const;
  void make_fine(std::int64_t windows, const T* coarse, T* fine);
  void differentiate_weight(std::int64_t windows, Rows<const T> padded_fine, const T* coarse);
  /// Returns the fine sides of windows with zero padding at either end.
  Rows<const T> pad_fine(std::int64_t windows, const T* fine);

  ConvolutionKind kind_;
  TrainedParameter<T> weight_;
  TrainedParameter<T> bias_;
  Numbers to_coarse_;  ///< the weight as [tap, fine channel][coarse channel]
  Numbers to_fine_;    ///< the weight as [half of the kernel, coarse channel][tap in the half, fine
                       ///< channel]
  Numbers padded_fine_;      ///< [windows, padding + fine side + padding]
  Numbers padded_coarse_;    ///< for one window, with a position of zeros at either end
  Numbers made_fine_;        ///< for one window, [coarse length + 1, held columns of to_fine_]
  Numbers packed_gradient_;  ///< in the order of to_coarse_
};

extern template class StridedConvolution<float>;
extern template class StridedConvolution<double>;

}  // namespace piae::nets
