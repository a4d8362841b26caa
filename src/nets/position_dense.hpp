#pragma once

#include <string>

#include "nets/gradient_array.hpp"
#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// The dense layer <name>/weight [outputs, inputs] and <name>/bias [outputs] (dense_specs()), at
/// each position by itself: y_t = W x_t + b.
template <class T>
class PositionDense final : public SequenceLayer<T> {
 public:
  PositionDense(GradientArray<T>& parameters, const std::string& name, std::int64_t length);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  TrainedParameter<T> weight_;
  TrainedParameter<T> bias_;
};

extern template class PositionDense<float>;
extern template class PositionDense<double>;

}  // namespace piae::nets
