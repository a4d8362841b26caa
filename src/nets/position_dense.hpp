#pragma once

#include <optional>
#include <string>

#include "nets/gradient_array.hpp"
#include "nets/sequence_layer.hpp"
#include "nets/weight_products.hpp"

namespace piae::nets {

/// Selects whether a dense layer has a bias.
enum class Bias { there, absent };

/// Returns <name>/weight [outputs, inputs] of a dense layer without a bias.
ParameterSpec unbiased_dense_spec(const std::string& name, std::int64_t inputs,
                                  std::int64_t outputs);

/// The dense layer <name>/weight [outputs, inputs] and <name>/bias [outputs] (dense_specs()),
/// separately at each position: y_t = W x_t + b.
template <class T>
class PositionDense final : public SequenceLayer<T> {
 public:
  PositionDense(GradientArray<T>& parameters, const std::string& name, std::int64_t length,
                Bias bias = Bias::there);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  WeightProducts<T> products_;
  std::optional<TrainedParameter<T>> bias_;
};

extern template class PositionDense<float>;
extern template class PositionDense<double>;

}  // namespace piae::nets
