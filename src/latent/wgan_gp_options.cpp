#include "latent/wgan_gp_options.hpp"

namespace piae::latent {

void bind(const cli::Options& command, WganGpOptions& o) {
  bind(command, o.networks);
  command
      .add("--critic-steps", o.critic_steps, "steps of the critic for each step of the generator")
      .check(cli::positive_number());
  command.add("--penalty", o.penalty, "weight lambda of the gradient penalty")
      .check(cli::non_negative_number());
}

}  // namespace piae::latent
