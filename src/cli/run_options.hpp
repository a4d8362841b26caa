#pragma once

#include <cstdint>

#include "base/compute.hpp"
#include "cli/options.hpp"

namespace piae::cli {

/// The options that all stages with neural networks share.
struct RunOptions {
  std::int64_t seed = 0;  ///< the repeat; part of the names of random streams; must be given
  Compute compute;
};

void bind(const cli::Options& command, RunOptions& options);

}  // namespace piae::cli
