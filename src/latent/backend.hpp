#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "latent/generator.hpp"
#include "latent/options.hpp"
#include "base/random.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::latent {

/// What a latent generator is trained on.
struct LatentTask {
  LatentGenerator generator;
  LatentOptions options;
  std::vector<float> windows;        ///< [n, N], without means, in units of their class's RMS
  std::vector<std::int32_t> labels;  ///< [n]
};

/// What computes a latent generator and the networks that are trained beside it, their gradients
/// and Adam: ours for one core, or LibTorch. The course of the training is LatentTraining's.
class LatentBackend {
 public:
  virtual ~LatentBackend() = default;

  /// One step, the index-th (from 0) of the whole training, by these known windows. Returns its
  /// losses, at the parameters before it. Noise is drawn from the stream in the same order by each
  /// back end.
  virtual std::vector<double> step(std::size_t index, std::span<const std::size_t> windows,
                                   Stream& noise) = 0;

  [[nodiscard]] virtual const std::vector<nets::ParameterSpec>& specs() const = 0;
  /// All parameters in the order of the specs.
  [[nodiscard]] virtual std::vector<float> values() const = 0;
  virtual void set_values(std::span<const float> values) = 0;

  /// Moments and steps of Adam, below /adam.
  virtual void write_adam(artefact::Writer& writer) const = 0;
  virtual void read_adam(const artefact::Reader& reader) = 0;
};

}  // namespace piae::latent
