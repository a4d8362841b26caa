#pragma once

#include "base/random.hpp"
#include "diffusion/backend.hpp"

namespace piae::diffusion {

/// Returns `count` points on paths, with alternating classes; the class of the last is not told.
inline NoisyBatch example_batch(std::int64_t samples, std::int64_t count) {
  Stream stream("points");
  NoisyBatch batch;
  for (std::int64_t i = 0; i < count; ++i) {
    batch.u.push_back(stream.uniform(0, 1));
    batch.labels.push_back(i + 1 < count ? std::optional(static_cast<Label>(i % 3)) : std::nullopt);
    for (std::int64_t t = 0; t < samples; ++t) {
      batch.windows.push_back(static_cast<float>(stream.normal(0, 1)));
    }
  }
  return batch;
}

inline std::vector<float> example_velocities(const NoisyBatch& batch) {
  Stream stream("velocities");
  std::vector<float> velocities(batch.windows.size());
  for (float& v : velocities) v = static_cast<float>(stream.normal(0, 0.3));
  return velocities;
}

}  // namespace piae::diffusion
