#pragma once

#include "cli/options.hpp"

namespace piae::latent {

/// The settings that the VAE and the WGAN-GP share. Each of the two has its own defaults.
struct LatentOptions {
  int epochs = 0;            ///< passes over the known windows
  int batch = 0;             ///< windows in a step
  double learning_rate = 0;  ///< of Adam, constant
  int latent = 0;            ///< Gaussian numbers that a window is made from
  int depth = 0;             ///< dense layers of each network
  int width = 0;             ///< units of a hidden layer
};

void bind(const cli::Options& command, LatentOptions& options);

}  // namespace piae::latent
