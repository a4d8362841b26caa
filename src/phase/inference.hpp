#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "base/random.hpp"
#include "nets/adam.hpp"
#include "nets/dense_chain.hpp"
#include "nets/parameters.hpp"
#include "nets/row_array.hpp"
#include "signal/window_set.hpp"
#include "twin/space.hpp"

namespace piae::phase {

/// The least and the largest (k~, c~) that can be inferred for a window.
struct Bounds {
  twin::TwinPoint low;
  twin::TwinPoint high;
};

/// The encoder of piae-dt-phase: infers (k~, c~) of a window whose class is known. A dense network
/// maps the window's autocorrelation (features.hpp), which does not depend on the start angle, and
/// the one-hot label to log k~ and log c~. It learns from solutions of eq. 13 with known (k, c)
/// (inference_training.hpp): amortised inference as in Cranmer, Brehmer and Louppe 2020.
class Inference {
 public:
  /// The group of a model or checkpoint that holds the inference, and its parameters.
  static const std::string group;
  static std::vector<nets::ParameterSpec> specs_of(std::int64_t classes, int width);

  /// Learns and infers in batches of up to `batch` windows. Initial values come from the stream.
  Inference(std::int64_t classes, int width, int batch, const Stream& stream);

  /// Returns one point for each window. Throws Error(bad_input) if a window is constant or not
  /// longer than feature_lags.
  [[nodiscard]] std::vector<twin::TwinPoint> infer(const signal::WindowSet& windows);

  /// Returns the features of windows, [n, feature_lags]. Throws like infer().
  [[nodiscard]] static nets::RowArray<float> features_of(const signal::WindowSet& windows);

  /// Returns the target outputs for these points, [n, 2]: log k~ and log c~, standardised as if
  /// they were uniform between the bounds of the window's class.
  [[nodiscard]] nets::RowArray<float> targets_of(const std::vector<twin::TwinPoint>& points,
                                                 const std::vector<Label>& labels) const;

  /// Takes one step of Adam on a batch; returns the mean squared error before the step.
  double learn(const nets::RowArray<float>& features, std::span<const Label> labels,
               const nets::RowArray<float>& targets, double learning_rate);

  /// Sets the scales of inputs and outputs. The points of each class then lie between its `bounds`,
  /// and features have the mean and the standard deviation of `features`.
  void set_scale(const std::vector<Bounds>& bounds, const nets::RowArray<float>& features);

  [[nodiscard]] const std::vector<Bounds>& bounds() const { return bounds_; }

  /// Weights and scales, below /inference. Reading throws artefact::Refusal if sizes differ, or if
  /// bounds or scales are not positive.
  void write(artefact::Writer& writer) const;
  void read(const artefact::Reader& reader);
  /// Write and read the state of Adam, as nets::AdamState in /inference/adam.
  void write_adam(artefact::Writer& writer) const;
  void read_adam(const artefact::Reader& reader);

 private:
  using Row = Eigen::Array<float, 1, Eigen::Dynamic>;
  [[nodiscard]] nets::RowArray<float> forward(const nets::RowArray<float>& features,
                                              std::span<const Label> labels);

  std::int64_t classes_;
  std::int64_t batch_;
  std::vector<nets::ParameterSpec> specs_;
  std::shared_ptr<nets::Parameters<float>> parameters_;
  nets::DenseChain<float> network_;
  std::int64_t steps_ = 0;      ///< Adam's steps so far
  std::vector<Bounds> bounds_;  ///< one per class
  Row feature_mean_;            ///< [feature_lags]
  Row feature_spread_;          ///< [feature_lags]
};

}  // namespace piae::phase
