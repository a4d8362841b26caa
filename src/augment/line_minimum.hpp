#pragma once

#include <cstdint>

namespace piae::augment {

/// Where a function of one variable is least, by Brent's method (1973) as Boost has it
/// (brent_find_minima), but asked the other way round: it says where it wants to know the function,
/// and is told. So searches can go on side by side, whose functions are computed together.
class LineMinimum {
 public:
  /// Between `low` and `high`, to about 2^-bits of the variable, with at most `most_values` values
  /// after the first.
  LineMinimum(double low, double high, int bits, int most_values);

  [[nodiscard]] bool done() const { return done_; }
  /// Where it wants to know the function next, unless it is done.
  [[nodiscard]] double next() const { return next_; }
  /// Tells it the function at next().
  void take(double value);
  /// Where the function was least so far.
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
  double step_ = 0;         ///< the last one
  double step_before_ = 0;  ///< and the one before that
  double next_;
  bool begun_ = false;
  bool done_ = false;
};

}  // namespace piae::augment
