#include "augment/latent_generator.hpp"

#include "augment/windows.hpp"
#include "nets/device.hpp"
#include "nets/torch.hpp"

namespace piae::augment {

namespace {

const std::string network = "net/generator";

}  // namespace

std::vector<nets::ParameterSpec> generator_specs(const LatentGenerator& generator) {
  return nets::dense_chain_specs(network, generator.latent + generator.classes(), generator.samples,
                                 generator.size);
}

torch::Tensor run_generator(const nets::ParameterSet& parameters, const torch::Tensor& z,
                            const torch::Tensor& classes) {
  return nets::run_dense_chain(parameters, network, torch::cat({z, classes}, 1));
}

torch::Tensor normal_numbers(Stream& stream, std::int64_t rows, std::int64_t columns) {
  std::vector<float> numbers(static_cast<std::size_t>(rows * columns));
  for (float& number : numbers) number = static_cast<float>(stream.normal(0, 1));
  return torch::tensor(numbers).view({rows, columns});
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
  generator.samples = reader.integer("/", "samples");
  generator.latent = reader.integer("/", "latent");
  generator.size = {static_cast<int>(reader.integer("/", "depth")),
                    static_cast<int>(reader.integer("/", "width"))};
  generator.rms = reader.numbers<double>("/classes/rms", {generator.info.classes.size()}).values;
  return generator;
}

signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           const std::string& device_name) {
  const torch::NoGradGuard no_grad;
  const torch::Device device = nets::prepare_device(device_name);
  const LatentGenerator generator = read_latent_generator(model);
  nets::ParameterSet parameters(generator_specs(generator), stream, torch::kFloat32, device);
  parameters.read(model, weights_group);
  const torch::Tensor one_hot = torch::eye(generator.classes(), torch::device(device));
  const auto make = [&](int label, std::size_t /*index*/, Stream& random) {
    const torch::Tensor z = normal_numbers(random, 1, generator.latent).to(device);
    const torch::Tensor window = run_generator(parameters, z, one_hot.narrow(0, label, 1));
    return nets::to_vector(window * generator.rms[static_cast<std::size_t>(label)]);
  };
  return make_windows(generator.info, static_cast<std::size_t>(generator.samples), count, stream,
                      make);
}

}  // namespace piae::augment
