#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>

#include "nets/adam.hpp"
#include "nets/parameters.hpp"

namespace piae::nets {

/// A parameter where it lies: `rows` rows of `columns` numbers, filled up with zeros to
/// `held_columns`, and its gradient in the same layout.
template <class T>
struct TrainedParameter {
  const T* values;
  T* gradient;
  std::int64_t rows;
  std::int64_t columns;
  std::int64_t held_columns;
};

/// The gradients of one network's parameters, in one array that lies as the parameters do, so that
/// the norm of all of them and Adam each go once over contiguous memory.
template <class T>
class GradientArray {
 public:
  /// For the parameters whose names begin with `network` and a slash. These must follow each other
  /// in the specs. Throws std::logic_error where none has such a name, or where they do not.
  GradientArray(std::shared_ptr<Parameters<T>> parameters, std::string network);

  /// The parameter <network>/<name>. Throws std::logic_error where there is none.
  [[nodiscard]] TrainedParameter<T> find(const std::string& name);
  /// What it was made from, in the same way.
  [[nodiscard]] const ParameterSpec& spec(const std::string& name) const {
    return parameters_->find(network_ + "/" + name).spec;
  }

  [[nodiscard]] double squared_norm() const;
  /// One step of Adam by the gradients times `scale`.
  void take(const AdamStep& step, double scale);

 private:
  std::shared_ptr<Parameters<T>> parameters_;
  std::string network_;
  std::int64_t begin_ = 0;  ///< in the arrays of the parameters
  Eigen::ArrayX<T> gradients_;
};

extern template class GradientArray<float>;
extern template class GradientArray<double>;

}  // namespace piae::nets
