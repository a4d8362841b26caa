#pragma once

#include "base/label.hpp"
#include "base/random.hpp"
#include "latent/backend.hpp"

namespace piae::latent {

/// Returns six windows of noise, with alternating classes, for networks of three layers.
inline LatentTask example_task(std::int64_t samples, std::size_t classes, std::int64_t latent,
                               int width = 9) {
  LatentTask task;
  task.generator.info.classes.resize(classes);
  task.generator.samples = samples;
  task.generator.latent = latent;
  task.generator.size = {3, width};
  task.options = {.epochs = 1,
                  .batch = 4,
                  .learning_rate = 1e-3,
                  .latent = static_cast<int>(latent),
                  .depth = 3,
                  .width = width};
  Stream stream("windows");
  for (std::size_t i = 0; i < 6; ++i) {
    task.labels.push_back(static_cast<Label>(i % classes));
    for (std::int64_t t = 0; t < samples; ++t) {
      task.windows.push_back(static_cast<float>(stream.normal(0, 1)));
    }
  }
  return task;
}

}  // namespace piae::latent
