#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/compute.hpp"
#include "base/random.hpp"
#include "nets/parameter_spec.hpp"
#include "twin/model.hpp"
#include "twin/network_shape.hpp"
#include "twin/options.hpp"
#include "twin/physics.hpp"
#include "twin/space.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// States of the known windows for a variant without an encoder.
struct KnownStates {
  std::vector<TwinPoint> points;          ///< k~ and c~ of each window
  std::vector<TwinPoint> decoder_inputs;  ///< what the decoder is given in their place
};

/// What is trained, and on what.
struct TwinTask {
  TwinVariant variant;
  TwinOptions options;
  NetworkShape shape;
  Physics physics;
  std::vector<float> windows;        ///< [n, N], without means, in units of their class's RMS
  std::vector<std::int32_t> labels;  ///< [n]
  std::optional<KnownStates> states;
};

/// Losses of a batch, at the parameters before the step. Without the physics module all but L_Rec
/// and the total, which is L_Rec, are 0.
struct BatchLosses {
  double reconstruction = 0;
  double differential = 0;
  double twin = 0;
  double total = 0;
};

enum class TrainingStage { one, two };

/// What computes the networks of a twin, their gradients and Adam. The course of the training, in
/// training.cpp, is the same with each.
class TwinBackend {
 public:
  virtual ~TwinBackend() = default;

  /// One step by these known windows. Stage 1, eq. 24: each network follows its own loss. Stage 2,
  /// eq. 25: all parameters follow the total. Gradients are clipped to options.max_gradient_norm,
  /// those of each network and of all parameters, respectively.
  virtual BatchLosses step(TrainingStage stage, std::span<const std::size_t> windows,
                           double learning_rate) = 0;

  /// All parameters: the networks', and the logarithms of the weights of the losses.
  [[nodiscard]] virtual const std::vector<nets::ParameterSpec>& specs() const = 0;
  /// As many numbers as the specs have together, in their order.
  virtual void copy_values(std::span<float> to) const = 0;
  virtual void set_values(std::span<const float> values) = 0;

  /// ln alpha, ln beta and ln gamma of eq. 23.
  [[nodiscard]] virtual std::array<float, 3> log_weights() const = 0;

  /// (k~, c~) that the networks, as they stand, give the known windows.
  [[nodiscard]] virtual std::vector<TwinPoint> states() = 0;

  /// Moments and steps of Adam, as <group>/networks and <group>/loss_weights.
  virtual void write_adam(artefact::Writer& writer, const std::string& group) const = 0;
  virtual void read_adam(const artefact::Reader& reader, const std::string& group) = 0;
};

/// The networks of a stored model, to compute with.
class StoredTwin {
 public:
  virtual ~StoredTwin() = default;

  /// Eq. 16: scaled windows [n, N] -> n points. Not for a variant without an encoder.
  [[nodiscard]] virtual std::vector<TwinPoint> encode(std::span<const float> windows) = 0;
  /// Eq. 17: acceleration [n, N] of a class, in units of its RMS.
  [[nodiscard]] virtual std::vector<float> decode(std::span<const TwinPoint> inputs,
                                                  std::size_t label) = 0;
};

/// A way to compute twins: ours for one core (dense_backend.hpp), LibTorch's on a device
/// (libtorch/back_ends.hpp).
struct Engine {
  /// Initial values come from `initial`; the task must outlive it. Throws Error(usage) for windows
  /// or a depth that the variant cannot have.
  std::function<std::unique_ptr<TwinBackend>(const TwinTask& task, const Stream& initial)> train;
  /// Throws artefact::Refusal for a model of another variant.
  std::function<std::unique_ptr<StoredTwin>(const artefact::Reader& model,
                                            const ModelDescription& description,
                                            const TwinVariant& variant)>
      open;
};

using MakeEngine = Engine (*)(Device device);

}  // namespace piae::twin
