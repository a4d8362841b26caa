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
#include "base/label.hpp"
#include "base/random.hpp"
#include "nets/parameter_spec.hpp"
#include "twin/model.hpp"
#include "twin/network_shape.hpp"
#include "twin/options.hpp"
#include "twin/physics.hpp"
#include "twin/space.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// States (k~, c~) of the known windows, for a variant without an encoder.
struct KnownStates {
  std::vector<TwinPoint> points;          ///< [n] k~ and c~ of each window
  std::vector<TwinPoint> decoder_inputs;  ///< [n] the two numbers that the decoder gets instead
};

/// A training task: the model, and n windows of N samples.
struct TwinTask {
  TwinVariant variant;
  TwinOptions options;
  NetworkShape shape;
  Physics physics;
  std::vector<float> windows;  ///< [n, N], each without its mean, in units of its class's RMS
  std::vector<Label> labels;   ///< [n]
  std::optional<KnownStates> states;  ///< required if the variant has no encoder
};

/// Losses of a batch at the parameters before the step. Without the physics module, L_DDL and L_DT
/// are 0 and the total is L_Rec.
struct BatchLosses {
  double reconstruction = 0;  ///< L_Rec, eq. 20
  double differential = 0;    ///< L_DDL, eq. 21
  double twin = 0;            ///< L_DT, eq. 22
  double total = 0;           ///< L_total, eq. 23
};

/// The two kinds of step, between which epochs alternate (paper 3.3.3).
enum class TrainingStage { one, two };

/// Learning rates of Adam in one step.
struct LearningRates {
  double networks = 0;
  double loss_weights = 0;  ///< for the logarithms of the loss weights
};

/// A back end: computes the networks of one twin, their gradients and the steps of Adam.
/// training.cpp chooses the batches and ends the training, for every back end alike.
class TwinBackend {
 public:
  virtual ~TwinBackend() = default;

  /// Takes one step on the known windows with these indices. In stage 1 (eq. 24) each network
  /// follows its own loss, and the gradients of each network are clipped to
  /// options.max_gradient_norm. In stage 2 (eq. 25) all parameters follow the total loss, and all
  /// gradients together are clipped.
  virtual BatchLosses step(TrainingStage stage, std::span<const std::size_t> windows,
                           const LearningRates& rates) = 0;

  /// Returns all parameters: those of the networks, and the logarithms of the loss weights.
  [[nodiscard]] virtual const std::vector<nets::ParameterSpec>& specs() const = 0;
  /// Copies the values of all parameters, in the order of the specs; nets::total_size() numbers.
  virtual void copy_values(std::span<float> to) const = 0;
  virtual void set_values(std::span<const float> values) = 0;

  /// Returns ln alpha, ln beta and ln gamma of eq. 23.
  [[nodiscard]] virtual std::array<float, 3> log_weights() const = 0;

  /// Returns the (k~, c~) that the current encoder infers from each known window, or those of the
  /// task if the variant has no encoder.
  [[nodiscard]] virtual std::vector<TwinPoint> states() = 0;

  /// Write and read the state of Adam, as nets::AdamState in <group>/networks and
  /// <group>/loss_weights.
  virtual void write_adam(artefact::Writer& writer, const std::string& group) const = 0;
  virtual void read_adam(const artefact::Reader& reader, const std::string& group) = 0;
};

/// The trained networks of a stored model.
class StoredTwin {
 public:
  virtual ~StoredTwin() = default;

  /// Eq. 16: returns the (k~, c~) of each of n windows [n, N], which must be scaled like those of
  /// the training. Not available without an encoder.
  [[nodiscard]] virtual std::vector<TwinPoint> encode(std::span<const float> windows) = 0;
  /// Eq. 17: returns the acceleration [n, N] for n inputs of this class, in units of the class's
  /// RMS.
  [[nodiscard]] virtual std::vector<float> decode(std::span<const TwinPoint> inputs,
                                                  Label label) = 0;
};

/// An implementation of twins: ours, for one core (one_core_backend.hpp), or LibTorch's, on a
/// device (seam/libtorch.hpp).
struct Engine {
  /// Makes the back end of one training, which owns the task. Initial values come from `initial`.
  /// Throws Error(usage) if the variant does not support the window length or the depth.
  std::function<std::unique_ptr<TwinBackend>(TwinTask task, const Stream& initial)> train;
  /// Opens the networks of a stored model. Throws artefact::Refusal if the model is of another
  /// variant.
  std::function<std::unique_ptr<StoredTwin>(const artefact::Reader& model,
                                            const ModelDescription& description,
                                            const TwinVariant& variant)>
      open;
};

using MakeEngine = Engine (*)(Device device);

}  // namespace piae::twin
