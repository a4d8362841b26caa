#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>

#include "nets/adam.hpp"
#include "nets/parameters.hpp"

namespace piae::nets {

/// View of a parameter: `rows` rows of `columns` numbers, padded with zeros to `held_columns`, and
/// its gradient in the same layout.
template <class T>
struct TrainedParameter {
  const T* values;
  T* gradient;
  std::int64_t rows;
  std::int64_t columns;
  std::int64_t held_columns;
};

/// The gradients of one network's parameters, in one array with the parameters' layout. So the norm
/// of all gradients and Adam each make one pass over contiguous memory.
template <class T>
class GradientArray {
 public:
  /// Takes the parameters whose names begin with `network` and a slash. Throws std::logic_error if
  /// none has such a name, or if they are not consecutive in the specs.
  GradientArray(std::shared_ptr<Parameters<T>> parameters, std::string network);

  /// Returns the parameter <network>/<name>. Throws std::logic_error if it does not exist.
  [[nodiscard]] TrainedParameter<T> find(const std::string& name);
  /// Returns the spec of that parameter, under the same conditions.
  [[nodiscard]] const ParameterSpec& spec(const std::string& name) const {
    return parameters_->find(network_ + "/" + name).spec;
  }

  [[nodiscard]] double squared_norm() const;
  /// Takes one step of Adam with the gradients times `scale`.
  void take(const AdamStep& step, double scale);

 private:
  std::shared_ptr<Parameters<T>> parameters_;
  std::string network_;
  std::int64_t begin_ = 0;  ///< index in the arrays of the parameters
  Eigen::ArrayX<T> gradients_;
};

extern template class GradientArray<float>;
extern template class GradientArray<double>;

}  // namespace piae::nets
