#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vector.hpp"

namespace piae::nets {

/// Constants of Adam that Kingma and Ba (2015) recommend.
struct AdamConstants {
  static constexpr double beta1 = 0.9;
  static constexpr double beta2 = 0.999;
  static constexpr double epsilon = 1e-8;
};

/// Numbers that all parameters share in step t = 1, 2, ... of Adam (Kingma and Ba 2015, Algorithm
/// 1).
struct AdamStep {
  AdamStep(std::int64_t t, double learning_rate, double beta1 = AdamConstants::beta1,
           double beta2 = AdamConstants::beta2);

  double beta1;
  double beta2;
  double rate;        ///< learning rate / (1 - beta1^t)
  double correction;  ///< 1 / sqrt(1 - beta2^t), a factor on the root of the second moment
};

/// One step of Adam for one parameter, or for a vector of them, computed in T. Fast only in files
/// compiled with -fno-math-errno (CMakeLists.txt): otherwise the square root must set errno.
template <class T>
class AdamUpdate {
 public:
  explicit AdamUpdate(const AdamStep& step)
      : beta1_(static_cast<T>(step.beta1)),
        beta2_(static_cast<T>(step.beta2)),
        newest1_(static_cast<T>(1 - step.beta1)),
        newest2_(static_cast<T>(1 - step.beta2)),
        rate_(static_cast<T>(step.rate)),
        correction_(static_cast<T>(step.correction)) {}

  template <class Numbers>  // T or Vector<T>
  void operator()(Numbers gradient, Numbers& value, Numbers& first_moment,
                  Numbers& second_moment) const {
    constexpr auto epsilon = static_cast<T>(AdamConstants::epsilon);
    first_moment = beta1_ * first_moment + newest1_ * gradient;
    second_moment = beta2_ * second_moment + newest2_ * gradient * gradient;
    value -= rate_ * first_moment / (root(second_moment) * correction_ + epsilon);
  }

 private:
  static T root(T x) { return std::sqrt(x); }
  static Vector<T> root(Vector<T> x) { return square_root<T>(x); }

  T beta1_;
  T beta2_;
  T newest1_;
  T newest2_;
  T rate_;
  T correction_;
};

/// Takes one step of Adam for `size` contiguous parameters. Passes over the four arrays once,
/// because the training of a small network waits for memory, not for arithmetic.
template <class T>
void take(const AdamStep& step, T* values, const T* gradients, T* first_moment, T* second_moment,
          std::size_t size);

/// Adam with its moments and its step count, for parameters in one array.
template <class T>
class Adam {
 public:
  explicit Adam(std::size_t size) : first_moment_(size), second_moment_(size) {}

  /// Takes one step. Both arrays have the size given to the constructor.
  void step(T* values, const T* gradients, double learning_rate);

 private:
  std::vector<T> first_moment_;
  std::vector<T> second_moment_;
  std::int64_t steps_ = 0;
};

extern template class Adam<float>;
extern template class Adam<double>;

}  // namespace piae::nets
