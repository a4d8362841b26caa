#pragma once

#include <cstdint>

#include "base/compute.hpp"
#include "cli/options.hpp"

namespace piae::cli {

/// What every stage with neural networks is told about the run.
struct RunOptions {
  std::int64_t seed = 0;  ///< the repeat; names the random streams. Must be given
  Compute compute;
};

void bind(const cli::Options& command, RunOptions& options);

}  // namespace piae::cli
