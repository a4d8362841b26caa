#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "base/random.hpp"
#include "latent/generator.hpp"
#include "latent/options.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::latent {

/// Training data of a latent generator: n windows of N samples.
struct LatentTask {
  LatentGenerator generator;
  LatentOptions options;
  std::vector<float> windows;  ///< [n, N], each without its mean, in units of its class's RMS
  std::vector<Label> labels;   ///< [n]
};

/// A back end: computes a latent generator and the second network of its training, their gradients
/// and the steps of Adam. There are two: our own, for one core, and LibTorch's. LatentTraining
/// chooses the batches and ends the training, for every back end alike.
class LatentBackend {
 public:
  virtual ~LatentBackend() = default;

  /// Takes one step on the known windows with these indices. `index` is the step number within the
  /// whole training, from 0. Returns the losses at the parameters before the step. Every back end
  /// draws the same numbers from `noise` in the same order.
  virtual std::vector<double> step(std::size_t index, std::span<const std::size_t> windows,
                                   Stream& noise) = 0;

  [[nodiscard]] virtual const std::vector<nets::ParameterSpec>& specs() const = 0;
  /// Returns all parameters in the order of the specs.
  [[nodiscard]] virtual std::vector<float> values() const = 0;
  virtual void set_values(std::span<const float> values) = 0;

  /// Write and read the state of Adam, as one or two nets::AdamState below /adam.
  virtual void write_adam(artefact::Writer& writer) const = 0;
  virtual void read_adam(const artefact::Reader& reader) = 0;
};

}  // namespace piae::latent
