#include "latent/options.hpp"

namespace piae::latent {

void bind(const cli::Options& command, LatentOptions& o) {
  command.add("--epochs", o.epochs, "passes over the known windows").check(cli::positive_number());
  command.add("--batch", o.batch, "windows in a batch").check(cli::positive_number());
  command.add("--learning-rate", o.learning_rate, "learning rate of Adam")
      .check(cli::positive_number());
  command.add("--latent", o.latent, "Gaussian numbers from which a window is generated")
      .check(cli::positive_number());
  command.add("--depth", o.depth, "dense layers of each network").check(cli::whole_number(1, 32));
  command.add("--width", o.width, "units of a hidden dense layer").check(cli::positive_number());
}

}  // namespace piae::latent
