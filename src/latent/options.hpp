#pragma once

#include "cli/options.hpp"

namespace piae::latent {

/// Settings that the VAE and the WGAN-GP share. Each has its own defaults.
struct LatentOptions {
  int epochs = 0;            ///< passes over the known windows
  int batch = 0;             ///< windows in a step
  double learning_rate = 0;  ///< rate of Adam, constant
  int latent = 0;            ///< Gaussian numbers from which a window is made
  int depth = 0;             ///< dense layers of each network
  int width = 0;             ///< units of a hidden layer
};

void bind(const cli::Options& command, LatentOptions& options);

}  // namespace piae::latent
