#include "augment/latent_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/numbers.hpp"

namespace piae::augment {

void bind(CLI::App& app, LatentOptions& o, const std::string& group) {
  const auto add = [&](const std::string& name, auto& value, const std::string& help) {
    return app.add_option(name, value, help)->group(group);
  };
  add("--epochs", o.epochs, "passes over the known windows")->check(cli::positive_number());
  add("--batch", o.batch, "windows in a batch")->check(cli::positive_number());
  add("--learning-rate", o.learning_rate, "of Adam")->check(cli::positive_number());
  add("--latent", o.latent, "Gaussian numbers that a window is made from")
      ->check(cli::positive_number());
  add("--depth", o.depth, "dense layers of each network")->check(CLI::Range(1, 32));
  add("--width", o.width, "units of a hidden layer")->check(cli::positive_number());
}

}  // namespace piae::augment
