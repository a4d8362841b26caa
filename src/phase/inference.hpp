#pragma once

#include <torch/types.h>

#include <cstdint>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "nets/parameters.hpp"
#include "signal/window_set.hpp"
#include "twin/space.hpp"

namespace piae::phase {

/// Stiffness and damping between which a window's are looked for.
struct Bounds {
  twin::TwinPoint low;
  twin::TwinPoint high;
};

/// The encoder of piae-dt-phase: (k~, c~) of a window of a known class. A dense network takes the
/// window's autocorrelation (features.hpp), which the start angle does not touch, and the one-hot
/// label, and gives log k~ and log c~. It has learned that from solutions of eq. 13 with known (k,
/// c) (inference_training.hpp): amortised inference, as in Cranmer, Brehmer and Louppe 2020.
class Inference {
 public:
  Inference(std::int64_t classes, int width, const Stream& stream, torch::Device device);

  /// One point for each window. Throws Error(bad_input) for windows that are constant or not longer
  /// than feature_lags.
  [[nodiscard]] std::vector<twin::TwinPoint> infer(const signal::WindowSet& windows) const;

  /// Features of windows, float32 [n, feature_lags], and one-hot labels [n, classes].
  [[nodiscard]] torch::Tensor features_of(const signal::WindowSet& windows) const;
  [[nodiscard]] torch::Tensor labels_of(const signal::WindowSet& windows) const;

  /// The network: log k~ and log c~ standardised over the bounds of the window's class, [n, 2].
  [[nodiscard]] torch::Tensor forward(const torch::Tensor& features,
                                      const torch::Tensor& labels) const;
  /// What forward() should give for these points.
  [[nodiscard]] torch::Tensor targets_of(const std::vector<twin::TwinPoint>& points,
                                         const std::vector<std::int32_t>& labels) const;

  /// From here on, points of a class lie within its bounds, and features have the mean and the
  /// spread of these.
  void set_scale(const std::vector<Bounds>& bounds, const torch::Tensor& features);

  [[nodiscard]] const std::vector<Bounds>& bounds() const { return bounds_; }
  nets::ParameterSet& parameters() { return parameters_; }

  /// Weights and scale, below /inference.
  void write(artefact::Writer& writer) const;
  void read(const artefact::Reader& reader);

 private:
  std::int64_t classes_;
  torch::Device device_;
  nets::ParameterSet parameters_;
  std::vector<Bounds> bounds_;    ///< of each class
  torch::Tensor feature_mean_;    ///< [feature_lags]
  torch::Tensor feature_spread_;  ///< [feature_lags]
};

}  // namespace piae::phase
