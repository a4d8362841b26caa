#pragma once

namespace piae {

/// The slope of a function by central differences at a number that it reads. The number is as it
/// was when this returns.
template <class Function>
double central_difference(double& number, double step, const Function& value) {
  const double before = number;
  number = before + step;
  const double above = value();
  number = before - step;
  const double below = value();
  number = before;
  return (above - below) / (2 * step);
}

}  // namespace piae
