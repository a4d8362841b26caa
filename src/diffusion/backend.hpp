#pragma once

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
#include "diffusion/denoiser.hpp"
#include "nets/parameter_spec.hpp"

namespace piae::diffusion {

/// The networks of a model. Their outputs are added. With two, the first was trained on healthy
/// windows and stays as it is while the second learns what a fault changes.
using Networks = std::vector<Denoiser>;

/// Points on the paths of n windows.
struct NoisyBatch {
  std::vector<float> windows;                ///< [n, N], in units of the class's RMS
  std::vector<double> u;                     ///< [n] place on the path
  std::vector<std::optional<Label>> labels;  ///< [n]; empty: the class is not told

  [[nodiscard]] std::int64_t size() const { return std::ssize(u); }
};

/// A back end: computes the networks, their gradients and the steps of Adam. There are two: our
/// own, for one core, and LibTorch's. DiffusionTraining draws all batches.
class DiffusionBackend {
 public:
  virtual ~DiffusionBackend() = default;

  /// Returns the velocities [n, N] by the first `networks` networks together.
  virtual std::vector<float> velocities(const NoisyBatch& batch, std::size_t networks) = 0;

  /// Takes one step of Adam with network `trained`, whose gradient norm is limited to 1. The
  /// networks before it add to the velocity, but stay as they are. Returns the mean squared error
  /// of the velocities [n, N] before the step.
  virtual double step(std::size_t trained, const NoisyBatch& batch,
                      std::span<const float> velocities, double learning_rate) = 0;

  [[nodiscard]] virtual const std::vector<nets::ParameterSpec>& specs() const = 0;
  /// Returns all parameters in the order of the specs.
  [[nodiscard]] virtual std::vector<float> values() const = 0;
  virtual void set_values(std::span<const float> values) = 0;

  /// Write and read the state of Adam, as a nets::AdamState below /adam for each network.
  virtual void write_adam(artefact::Writer& writer) const = 0;
  virtual void read_adam(const artefact::Reader& reader) = 0;
};

/// Limit of the norm of a step's gradient.
inline constexpr double largest_gradient_norm = 1;

/// Returns the parameters of all networks.
std::vector<nets::ParameterSpec> specs_of(const Networks& networks);

/// Makes a back end for batches of up to `most_windows` windows; initial values come from
/// `initial`.
using MakeDiffusionBackend = std::unique_ptr<DiffusionBackend> (*)(const Networks& networks,
                                                                   std::int64_t most_windows,
                                                                   const Stream& initial,
                                                                   Device device);

/// Our own back end, for one core.
std::unique_ptr<DiffusionBackend> one_core_diffusion(const Networks& networks,
                                                     std::int64_t most_windows,
                                                     const Stream& initial, Device device);

}  // namespace piae::diffusion
