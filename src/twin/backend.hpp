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

/// The states (k~, c~) of the known windows, for a variant that has no encoder to find them.
struct KnownStates {
  std::vector<TwinPoint> points;          ///< [n] k~ and c~ of each window
  std::vector<TwinPoint> decoder_inputs;  ///< [n] the two numbers that the decoder is given instead
};

/// What is trained, and on which n windows of N samples.
struct TwinTask {
  TwinVariant variant;
  TwinOptions options;
  NetworkShape shape;
  Physics physics;
  std::vector<float> windows;  ///< [n, N], each without its mean, in units of its class's RMS
  std::vector<Label> labels;   ///< [n]
  std::optional<KnownStates> states;  ///< given where the variant has no encoder
};

/// The losses of a batch at the parameters before the step. Without the physics module, L_DDL and
/// L_DT are 0 and the total is L_Rec.
struct BatchLosses {
  double reconstruction = 0;  ///< L_Rec, eq. 20
  double differential = 0;    ///< L_DDL, eq. 21
  double twin = 0;            ///< L_DT, eq. 22
  double total = 0;           ///< L_total, eq. 23
};

/// The two ways of taking a step, between which epochs alternate (paper 3.3.3).
enum class TrainingStage { one, two };

/// Of Adam, in one step.
struct LearningRates {
  double networks = 0;
  double loss_weights = 0;  ///< of their logarithms
};

/// A back end: it computes the networks of one twin, their gradients and the steps of Adam. Which
/// windows make a batch, and when a training ends, is decided in training.cpp, for every back end
/// alike.
class TwinBackend {
 public:
  virtual ~TwinBackend() = default;

  /// One step by the known windows with these indices. In stage 1 (eq. 24) each network follows its
  /// own loss, and the gradients of each network are clipped to options.max_gradient_norm. In stage
  /// 2 (eq. 25) all parameters follow the total loss, and all gradients together are clipped to it.
  virtual BatchLosses step(TrainingStage stage, std::span<const std::size_t> windows,
                           const LearningRates& rates) = 0;

  /// All parameters: those of the networks, and the logarithms of the weights of the losses.
  [[nodiscard]] virtual const std::vector<nets::ParameterSpec>& specs() const = 0;
  /// The values of all parameters in the order of the specs; nets::total_size() numbers.
  virtual void copy_values(std::span<float> to) const = 0;
  virtual void set_values(std::span<const float> values) = 0;

  /// ln alpha, ln beta and ln gamma of eq. 23.
  [[nodiscard]] virtual std::array<float, 3> log_weights() const = 0;

  /// The (k~, c~) that the encoder, as it is now, infers of each known window; for a variant
  /// without an encoder, those that the task gives.
  [[nodiscard]] virtual std::vector<TwinPoint> states() = 0;

  /// The state of Adam, as nets::AdamState in <group>/networks and <group>/loss_weights.
  virtual void write_adam(artefact::Writer& writer, const std::string& group) const = 0;
  virtual void read_adam(const artefact::Reader& reader, const std::string& group) = 0;
};

/// The trained networks of a stored model.
class StoredTwin {
 public:
  virtual ~StoredTwin() = default;

  /// Eq. 16: the (k~, c~) of each of n windows [n, N], which are scaled as those of the training
  /// were. A variant without an encoder cannot do this.
  [[nodiscard]] virtual std::vector<TwinPoint> encode(std::span<const float> windows) = 0;
  /// Eq. 17: for n inputs the acceleration [n, N] of a window of this class, in units of the
  /// class's RMS.
  [[nodiscard]] virtual std::vector<float> decode(std::span<const TwinPoint> inputs,
                                                  Label label) = 0;
};

/// A way to compute twins: ours, for one core (one_core_backend.hpp), or LibTorch's, on a device
/// (seam/libtorch.hpp).
struct Engine {
  /// Makes the back end of one training, which owns the task. Initial values come from `initial`.
  /// Throws Error(usage) for a length of window or a depth that the variant cannot have.
  std::function<std::unique_ptr<TwinBackend>(TwinTask task, const Stream& initial)> train;
  /// Opens the networks of a stored model. Throws artefact::Refusal for a model of another variant.
  std::function<std::unique_ptr<StoredTwin>(const artefact::Reader& model,
                                            const ModelDescription& description,
                                            const TwinVariant& variant)>
      open;
};

using MakeEngine = Engine (*)(Device device);

}  // namespace piae::twin
