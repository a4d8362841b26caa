#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/compute.hpp"
#include "base/random.hpp"
#include "nets/parameter_spec.hpp"
#include "signal/window_set.hpp"

namespace piae::latent {

/// A dense network that turns Gaussian numbers z and a class into a window: the decoder of a VAE,
/// the generator of a GAN. Its parameters are called net/generator/... in both.
struct LatentGenerator {
  signal::DatasetInfo info;
  std::int64_t samples = 0;  ///< of a window, N
  std::int64_t latent = 0;   ///< numbers in z
  nets::DenseSize size;
  std::vector<double> rms;  ///< of each class's known windows, in the recordings' unit

  [[nodiscard]] std::int64_t classes() const {
    return static_cast<std::int64_t>(info.classes.size());
  }
};

/// Where a model holds the weights.
inline const std::string weights_group = "/final";
inline const std::string generator_name = "net/generator";

/// z and one-hot class [latent + classes] -> window [N], in units of the class's RMS.
std::vector<nets::ParameterSpec> generator_specs(const LatentGenerator& generator);

/// Independent numbers of N(0, 1).
std::vector<float> normal_numbers(Stream& stream, std::size_t count);

/// All but the weights.
void write(artefact::Writer& writer, const LatentGenerator& generator);
LatentGenerator read_latent_generator(const artefact::Reader& reader);

/// A stored generator, to compute with.
class StoredGenerator {
 public:
  virtual ~StoredGenerator() = default;
  /// One window [N] of a class, in units of its RMS, from z [latent].
  [[nodiscard]] virtual std::vector<float> make(std::span<const float> z, std::size_t label) = 0;
};

/// Opens the weights of a model on "cpu" or "cuda".
using OpenGenerator = std::unique_ptr<StoredGenerator> (*)(const artefact::Reader& model,
                                                           const LatentGenerator& generator,
                                                           Device device);

std::unique_ptr<StoredGenerator> open_generator(const artefact::Reader& model,
                                                       const LatentGenerator& generator,
                                                       Device device);

/// Windows of a stored model, z drawn from N(0, 1), in the recordings' unit (signal/made_windows.hpp).
signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           OpenGenerator open, Device device);

}  // namespace piae::latent
