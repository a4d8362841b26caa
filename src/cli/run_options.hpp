#pragma once

#include <cstdint>

#include "base/compute.hpp"
#include "cli/options.hpp"

namespace piae::cli {

/// Options of all stages with neural networks.
struct RunOptions {
  std::int64_t seed = 0;  ///< number of the repeat, part of the names of random streams; required
  Compute compute;
};

void bind(const cli::Options& command, RunOptions& options);
void bind(const cli::Options& command, Compute& compute);

}  // namespace piae::cli
