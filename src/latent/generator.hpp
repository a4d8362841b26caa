#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/compute.hpp"
#include "base/label.hpp"
#include "base/random.hpp"
#include "nets/parameter_spec.hpp"
#include "signal/window_set.hpp"

namespace piae::latent {

/// A dense network that maps Gaussian numbers z and a class to a window: the decoder of a VAE or
/// the generator of a GAN. Its parameters are called net/generator/... in both.
struct LatentGenerator {
  signal::DatasetInfo info;
  std::int64_t samples = 0;  ///< N, samples of a window
  std::int64_t latent = 0;   ///< numbers in z
  nets::DenseSize size;
  std::vector<double> rms;  ///< RMS of each class's known windows, in the recordings' unit

  [[nodiscard]] std::int64_t classes() const {
    return static_cast<std::int64_t>(info.classes.size());
  }
};

/// Group of a model that holds the weights.
inline const std::string weights_group = "/final";
/// Prefix of the names of the generator's parameters; a slash follows.
inline const std::string generator_name = "net/generator";

/// Returns the specs of the generator's parameters: z and one-hot class [latent + classes] ->
/// window [N], in units of the class's RMS.
std::vector<nets::ParameterSpec> generator_specs(const LatentGenerator& generator);

/// Draws independent numbers from N(0, 1).
std::vector<float> normal_numbers(Stream& stream, std::size_t count);

/// Writes and reads a generator without its weights.
void write(artefact::Writer& writer, const LatentGenerator& generator);
LatentGenerator read_latent_generator(const artefact::Reader& reader);

/// The trained generator of a stored model.
class StoredGenerator {
 public:
  virtual ~StoredGenerator() = default;
  /// Makes one window [N] of a class from z [latent], in units of the class's RMS.
  [[nodiscard]] virtual std::vector<float> make(std::span<const float> z, Label label) = 0;
};

/// Opens the generator of a model on a device. Throws artefact::Refusal if the weights do not fit.
using OpenGenerator = std::unique_ptr<StoredGenerator> (*)(const artefact::Reader& model,
                                                           const LatentGenerator& generator,
                                                           Device device);

/// Opens the generator with our own networks, on one core.
std::unique_ptr<StoredGenerator> open_generator(const artefact::Reader& model,
                                                const LatentGenerator& generator, Device device);

/// Makes `count` windows of each class with a defect from a stored model, in the recordings' unit.
/// Draws z from N(0, 1) with the window's own random numbers (signal/made_windows.hpp).
signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           OpenGenerator open, Device device);

}  // namespace piae::latent
