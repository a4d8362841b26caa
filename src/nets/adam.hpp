#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace piae::nets {

/// Of Adam, as Kingma and Ba recommend.
struct AdamConstants {
  static constexpr double beta1 = 0.9;
  static constexpr double beta2 = 0.999;
  static constexpr double epsilon = 1e-8;
};

/// What Algorithm 1 of Kingma and Ba (2015) needs to know of step t = 1, 2, ...
struct AdamStep {
  AdamStep(std::int64_t t, double learning_rate, double beta1, double beta2);

  double beta1;
  double beta2;
  double rate;        ///< learning rate / (1 - beta1^t)
  double correction;  ///< of the second moment's root: 1 / sqrt(1 - beta2^t)
};

/// That step for one parameter, in T. A loop over it becomes vector instructions where the square
/// root need not set errno (CMakeLists.txt).
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

  void operator()(T gradient, T& value, T& first_moment, T& second_moment) const {
    constexpr auto epsilon = static_cast<T>(AdamConstants::epsilon);
    first_moment = beta1_ * first_moment + newest1_ * gradient;
    second_moment = beta2_ * second_moment + newest2_ * gradient * gradient;
    value -= rate_ * first_moment / (std::sqrt(second_moment) * correction_ + epsilon);
  }

 private:
  T beta1_;
  T beta2_;
  T newest1_;
  T newest2_;
  T rate_;
  T correction_;
};

/// That step over plain numbers in one pass: the arrays are what a small network's training waits
/// for. All have `size` numbers.
template <class T>
void take(const AdamStep& step, T* values, const T* gradients, T* first_moment, T* second_moment,
          std::size_t size);

/// Adam over plain numbers: what nets::Adam is over tensors.
template <class T>
class Adam {
 public:
  explicit Adam(std::size_t size) : first_moment_(size), second_moment_(size) {}

  /// Both arrays have the `size` of the constructor.
  void step(T* values, const T* gradients, double learning_rate);

 private:
  std::vector<T> first_moment_;
  std::vector<T> second_moment_;
  std::int64_t steps_ = 0;
};

extern template class Adam<float>;
extern template class Adam<double>;

}  // namespace piae::nets
