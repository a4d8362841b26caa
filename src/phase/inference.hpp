#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "nets/dense_chain.hpp"
#include "nets/adam.hpp"
#include "nets/parameters.hpp"
#include "nets/row_array.hpp"
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
  /// Learns in batches of up to `batch` windows.
  Inference(std::int64_t classes, int width, int batch, const Stream& stream);

  /// One point for each window. Throws Error(bad_input) for windows that are constant or not longer
  /// than feature_lags.
  [[nodiscard]] std::vector<twin::TwinPoint> infer(const signal::WindowSet& windows) const;

  /// Features of windows, [n, feature_lags].
  [[nodiscard]] static nets::RowArray<float> features_of(const signal::WindowSet& windows);

  /// What the network should give for these points: log k~ and log c~ standardised over the bounds
  /// of the window's class, [n, 2].
  [[nodiscard]] nets::RowArray<float> targets_of(const std::vector<twin::TwinPoint>& points,
                                                 const std::vector<std::int32_t>& labels) const;

  /// One step of Adam by a batch; returns the mean squared error before it.
  double learn(const nets::RowArray<float>& features, std::span<const std::int32_t> labels,
               const nets::RowArray<float>& targets, double learning_rate);

  /// From here on, points of a class lie within its bounds, and features have the mean and the
  /// spread of these.
  void set_scale(const std::vector<Bounds>& bounds, const nets::RowArray<float>& features);

  [[nodiscard]] const std::vector<Bounds>& bounds() const { return bounds_; }

  /// Weights and scale, below /inference.
  void write(artefact::Writer& writer) const;
  void read(const artefact::Reader& reader);
  /// Moments and steps of Adam, below /inference/adam.
  void write_adam(artefact::Writer& writer) const;
  void read_adam(const artefact::Reader& reader);

 private:
  using Row = Eigen::Array<float, 1, Eigen::Dynamic>;
  [[nodiscard]] nets::RowArray<float> forward(const nets::RowArray<float>& features,
                                              std::span<const std::int32_t> labels) const;

  std::int64_t classes_;
  std::int64_t batch_;
  std::vector<nets::ParameterSpec> specs_;
  nets::Parameters<float> parameters_;
  mutable nets::DenseChain<float> network_;  ///< keeps what passes through it
  std::int64_t steps_ = 0;
  std::vector<Bounds> bounds_;  ///< of each class
  Row feature_mean_;            ///< [feature_lags]
  Row feature_spread_;          ///< [feature_lags]
};

}  // namespace piae::phase
