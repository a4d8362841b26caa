#include "latent/specs.hpp"

namespace piae::latent {

namespace {

/// The generator's, and those of a network that reads windows.
std::vector<nets::ParameterSpec> with_reader(const LatentGenerator& generator,
                                             const std::string& name, std::int64_t outputs) {
  std::vector<nets::ParameterSpec> specs = generator_specs(generator);
  const auto others = nets::dense_chain_specs(name, generator.samples + generator.classes(),
                                              outputs, generator.size);
  specs.insert(specs.end(), others.begin(), others.end());
  return specs;
}

}  // namespace

std::vector<nets::ParameterSpec> vae_specs(const LatentGenerator& generator) {
  return with_reader(generator, encoder_name, 2 * generator.latent);
}

std::vector<nets::ParameterSpec> wgan_gp_specs(const LatentGenerator& generator) {
  return with_reader(generator, critic_name, 1);
}

}  // namespace piae::latent
