#pragma once

namespace piae {

/// Returns the slope of a function by central differences with respect to a number that it reads.
/// The number is restored.
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
