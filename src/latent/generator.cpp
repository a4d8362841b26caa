#include "latent/generator.hpp"

#include "nets/ranges.hpp"
#include "signal/amplitude.hpp"
#include "signal/made_windows.hpp"
#include "signal/ranges.hpp"

namespace piae::latent {

std::vector<nets::ParameterSpec> generator_specs(const LatentGenerator& generator) {
  return nets::dense_chain_specs(generator_name, generator.latent + generator.classes(),
                                 generator.samples, generator.size);
}

std::vector<float> normal_numbers(Stream& stream, std::size_t count) {
  std::vector<float> numbers(count);
  for (float& number : numbers) number = static_cast<float>(stream.normal(0, 1));
  return numbers;
}

void write(artefact::Writer& writer, const LatentGenerator& generator) {
  signal::write(writer, generator.info);
  writer.attribute("/", "samples", generator.samples);
  writer.attribute("/", "latent", generator.latent);
  writer.attribute("/", "depth", std::int64_t{generator.size.depth});
  writer.attribute("/", "width", std::int64_t{generator.size.width});
  writer.numbers("/classes/rms", generator.rms);
}

LatentGenerator read_latent_generator(const artefact::Reader& reader) {
  LatentGenerator generator;
  generator.info = signal::read_dataset_info(reader);
  generator.samples = reader.integer("/", "samples", signal::ranges::window_samples);
  generator.latent = reader.integer("/", "latent", nets::ranges::latent);
  generator.size = {.depth = static_cast<int>(reader.integer("/", "depth", nets::ranges::depth)),
                    .width = static_cast<int>(reader.integer("/", "width", nets::ranges::width))};
  generator.rms = signal::read_amplitudes(reader, "/classes/rms", generator.info);
  return generator;
}

signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           OpenGenerator open, Device device) {
  const LatentGenerator generator = read_latent_generator(model);
  const std::unique_ptr<StoredGenerator> network = open(model, generator, device);
  const auto make = [&](Label label, std::size_t /*index*/, Stream& random) {
    std::vector<float> window =
        network->make(normal_numbers(random, static_cast<std::size_t>(generator.latent)), label);
    for (float& x : window) x *= static_cast<float>(generator.rms[index_of(label)]);
    return window;
  };
  return signal::make_windows(generator.info, static_cast<std::size_t>(generator.samples), count,
                              stream, make);
}

}  // namespace piae::latent
