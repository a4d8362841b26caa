#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "nets/gradient_array.hpp"
#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Returns <name>/scale, which starts at 1, and <name>/shift, which starts at 0, [width] each.
std::vector<ParameterSpec> layer_normalisation_specs(const std::string& name, std::int64_t width);

/// Layer normalisation (Ba, Kiros and Hinton 2016), separately at each position: the numbers minus
/// their mean, divided by their standard deviation, times the scale, plus the shift.
template <class T>
class LayerNormalisation final : public SequenceLayer<T> {
 public:
  static constexpr double epsilon = 1e-5;  ///< added to the variance, as in LibTorch

  /// The width must be whole rows.
  LayerNormalisation(GradientArray<T>& parameters, const std::string& name, std::int64_t length);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  TrainedParameter<T> scale_;
  TrainedParameter<T> shift_;
  Eigen::ArrayX<T> normalised_;  ///< [windows, length, width]
  Eigen::ArrayX<T> factor_;      ///< 1 / the standard deviation, [windows, length]
};

extern template class LayerNormalisation<float>;
extern template class LayerNormalisation<double>;

}  // namespace piae::nets
