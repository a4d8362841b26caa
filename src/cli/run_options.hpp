#pragma once

#include <cstdint>
#include <string>

#include "cli/options.hpp"

namespace piae::cli {

/// What every stage with neural networks is told about the run.
struct RunOptions {
  std::int64_t seed = 0;       ///< the repeat; names the random streams. Must be given
  std::string device = "cpu";  ///< cpu or cuda
};

void bind(const cli::Options& command, RunOptions& options);

}  // namespace piae::cli
