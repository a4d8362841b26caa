#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "base/vector.hpp"

namespace piae::nets {

// Logistic function and hyperbolic tangent of a vector of numbers. The C library's functions take
// one number at a time and are many times slower. The error is a few units in the last place, also
// near zero. A NaN stays a NaN. Intermediate results are not denormal, except the square in tanh of
// numbers below 1e-19.

namespace detail {

/// Constants of the exponential function for float and double.
template <class T>
struct ExponentialOf;
template <>
struct ExponentialOf<float> {
  using Bits = std::int32_t;
  static constexpr int mantissa_bits = 23;
  static constexpr int degree = 7;        ///< degree of the polynomial, whose error is 5e-9
  static constexpr float largest = 87;    ///< e^87 and e^-87 are normal numbers
  static constexpr float saturated = 10;  ///< from here on tanh is 1
  // ln 2 as a sum of two parts. The first has so few digits that its product with an exponent is
  // exact.
  static constexpr float ln2 = 0.693359375F;
  static constexpr float rest_of_ln2 = -2.12194440e-4F;
};
template <>
struct ExponentialOf<double> {
  using Bits = std::int64_t;
  static constexpr int mantissa_bits = 52;
  static constexpr int degree = 13;  ///< error 4e-18
  static constexpr double largest = 708;
  static constexpr double saturated = 20;
  static constexpr double ln2 = 6.93147180369123816490e-01;
  static constexpr double rest_of_ln2 = 1.90821492927058770002e-10;
};

/// Returns 1 / n! for n = 0, 1, ..., degree.
template <class T, int degree>
constexpr std::array<T, degree + 1> taylor_of_exponential() {
  std::array<T, degree + 1> coefficients{};
  double factorial = 1;
  for (int n = 0; n <= degree; ++n) {
    if (n > 0) factorial *= n;
    coefficients[static_cast<std::size_t>(n)] = static_cast<T>(1 / factorial);
  }
  return coefficients;
}

/// e^x as power * (1 + rest), where the rest is between -0.3 and 0.42.
template <class T>
struct Exponential {
  Vector<T> power;  ///< a power of 2
  Vector<T> rest;
};

/// Requires |x| <= ExponentialOf<T>::largest.
template <class T>
Exponential<T> exponential(Vector<T> x) {
  using Of = ExponentialOf<T>;
  using Bits = typename Of::Bits;
  constexpr auto coefficients = taylor_of_exponential<T, Of::degree>();
  // A number this large has no fractional digits, so adding it rounds the other summand. The last
  // bits of the sum are then the rounded number.
  constexpr T rounder = static_cast<T>(Bits{3} << (Of::mantissa_bits - 1));
  constexpr T one_over_ln2 = static_cast<T>(1.44269504088896340736);
  const Vector<T> rounded = x * one_over_ln2 + rounder;
  const Vector<T> exponent = rounded - rounder;
  const Vector<T> r = (x - exponent * Of::ln2) - exponent * Of::rest_of_ln2;
  Vector<T> sum = Vector<T>{} + coefficients[Of::degree];
#pragma GCC unroll 16
  for (int n = Of::degree - 1; n >= 2; --n)
    sum = sum * r + coefficients[static_cast<std::size_t>(n)];
  const Vector<T> one = Vector<T>{} + T{1};
  const auto bits =
      ((Vector<Bits>)rounded << Of::mantissa_bits) + (Vector<Bits>)one;  // NOLINT: the same bits
  return {.power = (Vector<T>)bits, .rest = r + r * r * sum};            // NOLINT
}

}  // namespace detail

/// Returns 1 / (1 + e^-x).
template <class T>
Vector<T> sigmoid(Vector<T> x) {
  constexpr T largest = detail::ExponentialOf<T>::largest;
  x = x > largest ? Vector<T>{} + largest : x;
  x = x < -largest ? Vector<T>{} - largest : x;
  const auto e = detail::exponential<T>(-x);
  return T{1} / (T{1} + e.power + e.power * e.rest);
}

/// Returns (e^2x - 1) / (e^2x + 1), where e^2x - 1 keeps its digits near zero.
template <class T>
Vector<T> tanh(Vector<T> x) {
  constexpr T saturated = detail::ExponentialOf<T>::saturated;
  const Vector<T> size = x < T{0} ? -x : x;
  const auto e = detail::exponential<T>(T{2} * (size > saturated ? Vector<T>{} + saturated : size));
  const Vector<T> less_one = e.power * e.rest + (e.power - T{1});
  const Vector<T> of_size = less_one / (less_one + T{2});
  return x < T{0} ? -of_size : of_size;
}

}  // namespace piae::nets
