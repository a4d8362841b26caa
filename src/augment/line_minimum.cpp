#include "augment/line_minimum.hpp"

#include <cmath>

namespace piae::augment {

LineMinimum::LineMinimum(double low, double high, int bits, int most_values)
    : low_(low),
      high_(high),
      tolerance_(std::ldexp(1.0, 1 - bits)),
      values_left_(most_values),
      best_{high, 0},
      second_(best_),
      third_(best_),
      next_(high) {}

void LineMinimum::take(double value) {
  if (started_) {
    bracket({next_, value});
    --values_left_;
  } else {
    best_.value = second_.value = third_.value = value;
    started_ = true;
  }
  done_ = values_left_ == 0;
  if (!done_) choose_next();
}

void LineMinimum::bracket(const Point& newest) {
  if (newest.value <= best_.value) {
    (newest.at >= best_.at ? low_ : high_) = best_.at;
    third_ = second_;
    second_ = best_;
    best_ = newest;
    return;
  }
  (newest.at < best_.at ? low_ : high_) = newest.at;
  if (newest.value <= second_.value || second_.at == best_.at) {
    third_ = second_;
    second_ = newest;
  } else if (newest.value <= third_.value || third_.at == best_.at || third_.at == second_.at) {
    third_ = newest;
  }
}

void LineMinimum::choose_next() {
  constexpr double golden = 0.3819660F;  // rounded to float, as in Boost
  const auto [x, fx] = best_;
  const auto [w, fw] = second_;
  const auto [v, fv] = third_;
  const double middle = (low_ + high_) / 2;
  const double least_step = tolerance_ * std::abs(x) + tolerance_ / 4;
  const double least_gap = 2 * least_step;
  if (std::abs(x - middle) <= least_gap - (high_ - low_) / 2) {
    done_ = true;
    return;
  }
  bool golden_section = true;
  if (std::abs(step_before_) > least_step) {
    // The step to the vertex of the parabola through the three points is p / q.
    const double r = (x - w) * (fx - fv);
    double q = (x - v) * (fx - fw);
    double p = (x - v) * q - (x - w) * r;
    q = 2 * (q - r);
    if (q > 0) p = -p;
    q = std::abs(q);
    const double before = step_before_;
    step_before_ = step_;
    golden_section =
        std::abs(p) >= std::abs(q * before / 2) || p <= q * (low_ - x) || p >= q * (high_ - x);
    if (!golden_section) {
      step_ = p / q;
      const double u = x + step_;
      if (u - low_ < least_gap || high_ - u < least_gap) {
        step_ = middle - x < 0 ? -least_step : least_step;
      }
    }
  }
  if (golden_section) {
    step_before_ = x >= middle ? low_ - x : high_ - x;
    step_ = golden * step_before_;
  }
  const double shortest = step_ > 0 ? least_step : -least_step;
  next_ = x + (std::abs(step_) >= least_step ? step_ : shortest);
}

}  // namespace piae::augment
