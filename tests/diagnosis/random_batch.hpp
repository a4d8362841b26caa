#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "diagnosis/wdcnn_layout.hpp"

namespace piae::diagnosis {

/// Windows of noise with random labels, in the form that a network for one core takes.
struct RandomBatch {
  std::int64_t length;
  std::vector<float> samples;
  std::vector<const float*> windows;
  std::vector<std::int32_t> labels;
};

inline RandomBatch random_batch(std::int64_t n, std::int64_t length, std::int64_t classes,
                                const std::string& name) {
  Stream stream(name);
  RandomBatch batch{length, std::vector<float>(static_cast<std::size_t>(n * length)), {}, {}};
  for (float& x : batch.samples) x = static_cast<float>(stream.normal(0, 1));
  for (std::int64_t i = 0; i < n; ++i) {
    batch.windows.push_back(batch.samples.data() + i * length);
    batch.labels.push_back(static_cast<std::int32_t>(stream.below(classes)));
  }
  return batch;
}

/// Returns the numbers of a parameter or of its gradient from the flat vector, in the order of its
/// shape.
template <class T>
std::vector<double> unfolded(const WdcnnParameter& parameter, std::span<const T> flat) {
  std::vector<double> result(static_cast<std::size_t>(parameter.spec.size()));
  parameter.for_each([&](std::int64_t i, std::int64_t j) {
    result[static_cast<std::size_t>(i)] = flat[static_cast<std::size_t>(j)];
  });
  return result;
}

inline void expect_near(const std::vector<double>& ours, const std::vector<double>& theirs,
                        double relative, const std::string& what) {
  ASSERT_EQ(ours.size(), theirs.size()) << what;
  double greatest = 0;
  for (const double x : theirs) greatest = std::max(greatest, std::abs(x));
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ASSERT_NEAR(ours[i], theirs[i], relative * greatest) << what << " " << i;
  }
}

}  // namespace piae::diagnosis
