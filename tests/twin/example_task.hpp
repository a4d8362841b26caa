#pragma once

#include <cstdint>
#include <vector>

#include "signal/amplitude.hpp"
#include "signal/scaling.hpp"
#include "support/known_windows.hpp"
#include "twin/backend.hpp"

namespace piae::twin {

/// A variant of the twin, and options of its losses.
struct TaskOf {
  const char* name;
  TwinVariant variant;
  LossWeights loss_weights;
  double max_gradient_norm;     ///< 0.01 clips
  bool other_readings = false;  ///< interpretations other than the default
};

/// Returns a task that trains on known_windows().
inline TwinTask task_of(const TaskOf& c) {
  const signal::WindowSet known = known_windows();
  const std::vector<double> scale = signal::rms_by_class(known);
  TwinTask task;
  task.variant = c.variant;
  task.options.width = 24;
  task.options.loss_weights = c.loss_weights;
  task.options.max_gradient_norm = c.max_gradient_norm;
  if (c.other_readings) {
    task.options.positive = Positive::exponential;
    task.options.squares = Squares::sum;
    task.options.mmd = Mmd::root;
    task.options.residual = Residual::absolute;
    task.options.derivatives = Derivatives::spectral;
    task.options.contact = ContactInterpretation::passing;
  }
  task.shape = {static_cast<std::int64_t>(known.length),
                static_cast<std::int64_t>(known.info.classes.size())};
  task.physics = make_physics(known.info, scale, task.shape.samples, task.options);
  task.windows = signal::scaled_windows(known, scale);
  task.labels = known.labels;
  if (c.variant.encoder) return task;
  task.states.emplace();
  for (std::size_t i = 0; i < task.labels.size(); ++i) {
    const auto x = static_cast<double>(i);
    task.states->points.push_back({1 + 0.1 * x, 5 - 0.2 * x});
    task.states->decoder_inputs.push_back({0.3 * x - 1, 1 - 0.1 * x});
  }
  return task;
}

inline std::vector<float> values_of(const TwinBackend& backend) {
  std::vector<float> values(nets::total_size(backend.specs()));
  backend.copy_values(values);
  return values;
}

}  // namespace piae::twin
