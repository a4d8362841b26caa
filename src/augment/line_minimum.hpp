#pragma once

#include <cstdint>

namespace piae::augment {

/// Finds the minimum of a function of one variable by Brent's method (1973), as in Boost
/// (brent_find_minima). The caller computes the function: next() returns where, take() receives the
/// value. So many searches can run at once and have their functions computed together.
class LineMinimum {
 public:
  /// Starts at `high` and searches down to `low`. Ends at a relative tolerance of about
  /// 2^(1 - bits), or after `most_values` values in addition to that at `high`.
  LineMinimum(double low, double high, int bits, int most_values);

  [[nodiscard]] bool done() const { return done_; }
  /// Returns the point at which the next value is needed; undefined if done().
  [[nodiscard]] double next() const { return next_; }
  /// Receives the function's value at next().
  void take(double value);
  /// Returns the point with the least value so far.
  [[nodiscard]] double best() const { return best_.at; }

 private:
  struct Point {
    double at;
    double value;
  };
  void bracket(const Point& newest);
  void choose_next();

  double low_;
  double high_;
  double tolerance_;
  int values_left_;
  Point best_;
  Point second_;
  Point third_;
  double step_ = 0;         ///< the last step
  double step_before_ = 0;  ///< the step before the last
  double next_;
  bool started_ = false;
  bool done_ = false;
};

}  // namespace piae::augment
