#include "cli/run_options.hpp"

namespace piae::cli {

void bind(const cli::Options& command, RunOptions& options) {
  command.add("--seed", options.seed, "the repeat; names the random streams")
      .required()
      .check(natural_number());
  command.add("--device", options.compute.device, "cpu or cuda, for networks");
  command.add("--backend", options.compute.backend,
              "what computes networks: native (one core, the fastest), libtorch, or auto: native "
              "where it can be");
}

}  // namespace piae::cli
