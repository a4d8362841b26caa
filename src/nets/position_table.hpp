#pragma once

#include <string>
#include <vector>

#include "nets/gradient_array.hpp"
#include "nets/sequence_layer.hpp"

namespace piae::nets {

/// Returns <name> [length, width]. The table acts like a dense layer on the one-hot vector of the
/// position, in which only one number is not 0. So its initial bound is that of a unit with one
/// input.
std::vector<ParameterSpec> position_table_specs(const std::string& name,
                                                const SequenceShape& shape);

/// Adds learned numbers to each position (Gehring et al. 2017): y_t = x_t + p_t.
template <class T>
class PositionTable final : public SequenceLayer<T> {
 public:
  /// The width must be whole rows.
  PositionTable(GradientArray<T>& parameters, const std::string& name);

  void forward(std::int64_t windows, const T* x, T* y) override;
  void backward(const SignalBatch& batch, const T* x, const T* dy, T* dx) override;

 private:
  TrainedParameter<T> table_;
};

extern template class PositionTable<float>;
extern template class PositionTable<double>;

}  // namespace piae::nets
