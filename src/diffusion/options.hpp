#pragma once

#include "cli/options.hpp"
#include "diffusion/denoiser.hpp"
#include "diffusion/path.hpp"

namespace piae::diffusion {

/// One training of a network: on the known windows, or on healthy ones.
struct Course {
  int epochs = 0;            ///< passes over the windows
  int batch = 0;             ///< windows in a step
  double learning_rate = 0;  ///< of Adam, at the start; falls as half a cosine
  const char* rate_option = "--learning-rate";
};

/// Settings of a diffusion or flow model.
struct DiffusionOptions {
  Path path = Path::diffusion;
  Course course;
  DenoiserSize size;
  double dropped = 0;   ///< share of windows whose class is not told, for guidance
  double guidance = 0;  ///< w of classifier-free guidance (Ho and Salimans 2022, eq. 6)
  int steps = 0;        ///< of the way from noise to a window
};

inline constexpr DiffusionOptions ddpm_defaults{
    .path = Path::diffusion,
    .course = {.epochs = 2000, .batch = 45, .learning_rate = 2e-3},
    .size = {.channels = 48, .blocks = 6},
    .dropped = 0.1,  // Ho and Salimans 2022
    .guidance = 0,
    .steps = 50};
inline constexpr DiffusionOptions flow_defaults{
    .path = Path::flow,
    .course = {.epochs = 2000, .batch = 15, .learning_rate = 2e-3},
    .size = {.channels = 48, .blocks = 3},
    .dropped = 0.1,
    .guidance = 0,
    .steps = 8};

/// Settings of a model that learns the healthy windows first.
struct HealthyOptions {
  Course course{.epochs = 150,  ///< on the healthy windows
                .batch = 50,
                .learning_rate = 2e-3,
                .rate_option = "--healthy-learning-rate"};
  DenoiserSize change{.channels = 32, .blocks = 6};  ///< of the network of what a fault changes
};

void bind(const cli::Options& command, DiffusionOptions& options);
/// Throws Error(usage) for a guidance without dropped classes: it would need a velocity that was
/// never trained.
void require_possible(const DiffusionOptions& options);
void bind(const cli::Options& command, HealthyOptions& options);

}  // namespace piae::diffusion
