#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "support/checkpoints.hpp"

namespace piae {

/// Returns Adam's first moment of a group that `write_adam` stores. After one step it is 1 - beta1
/// times the gradient.
inline std::vector<float> first_moments(const std::function<void(artefact::Writer&)>& write_adam,
                                        const std::string& group) {
  artefact::Writer writer("model");
  write_adam(writer);
  const auto path = scratch_file("first_moments.h5");
  writer.save(path, {});
  return artefact::Reader(path, "model").numbers<float>(group + "/first_moment", {0}).values;
}

/// Returns |a - b| / |b|.
inline double relative_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double squares = 0;
  double size = 1e-30;  // for moments that are all 0
  for (std::size_t i = 0; i < b.size(); ++i) {
    squares += std::pow(static_cast<double>(a.at(i)) - b[i], 2);
    size += std::pow(static_cast<double>(b[i]), 2);
  }
  return std::sqrt(squares / size);
}

/// Expects that `gradient` is the gradient of `loss`, a function in single precision, at `values`:
/// central differences along it, and along each half of it, give the same slope.
inline void expect_gradient_of(const std::vector<float>& gradient, const std::vector<float>& values,
                               const std::function<double(const std::vector<float>&)>& loss) {
  ASSERT_EQ(gradient.size(), values.size());
  double squares = 0;
  for (const float g : gradient) squares += static_cast<double>(g) * g;
  const double length = std::sqrt(squares);
  ASSERT_GT(length, 0);
  const auto slope_along = [&](const std::vector<double>& direction) {
    constexpr double step = 5e-4;
    const auto at = [&](double distance) {
      std::vector<float> moved = values;
      for (std::size_t i = 0; i < moved.size(); ++i) {
        moved[i] += static_cast<float>(distance * direction[i]);
      }
      return loss(moved);
    };
    return (at(step) - at(-step)) / (2 * step);
  };
  std::vector<double> along(gradient.begin(), gradient.end());
  for (double& x : along) x /= length;
  EXPECT_NEAR(slope_along(along), length, 0.02 * length);
  // Each half is tested separately, so that errors cannot cancel.
  for (const bool second : {false, true}) {
    std::vector<double> half = along;
    double part = 0;
    for (std::size_t i = 0; i < half.size(); ++i) {
      if ((i >= half.size() / 2) != second) half[i] = 0;
      part += half[i] * gradient[i];
    }
    EXPECT_NEAR(slope_along(half), part, 0.02 * length) << (second ? "second half" : "first half");
  }
}

}  // namespace piae
