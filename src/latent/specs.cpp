#include "latent/specs.hpp"

namespace piae::latent {

namespace {

/// Returns the parameters of the generator and of a network whose inputs are windows with classes.
std::vector<nets::ParameterSpec> with_reader(const LatentGenerator& generator,
                                             const std::string& name, std::int64_t outputs) {
  std::vector<nets::ParameterSpec> specs = generator_specs(generator);
  append(specs, nets::dense_chain_specs(name, generator.samples + generator.classes(), outputs,
                                        generator.size));
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
