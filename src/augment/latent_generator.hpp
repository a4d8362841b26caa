#pragma once

#include <torch/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "nets/dense.hpp"
#include "signal/window_set.hpp"

namespace piae::augment {

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

std::vector<nets::ParameterSpec> generator_specs(const LatentGenerator& generator);

/// z [n, latent] and one-hot classes [n, classes] -> windows [n, N], in units of the class's RMS.
torch::Tensor run_generator(const nets::ParameterSet& parameters, const torch::Tensor& z,
                            const torch::Tensor& classes);

/// Independent numbers of N(0, 1), [rows, columns], as float32 on the processor.
torch::Tensor normal_numbers(Stream& stream, std::int64_t rows, std::int64_t columns);

/// All but the weights.
void write(artefact::Writer& writer, const LatentGenerator& generator);
LatentGenerator read_latent_generator(const artefact::Reader& reader);

/// Windows of a stored model, z drawn from N(0, 1), in the recordings' unit (augment/windows.hpp).
signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           const std::string& device);

}  // namespace piae::augment
