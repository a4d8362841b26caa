#include "cli/run_options.hpp"

namespace piae::cli {

void bind(const cli::Options& command, RunOptions& options) {
  command.add("--seed", options.seed, "the repeat; names the random streams")
      .required()
      .check(natural_number());
  command.add("--device", options.device, "cpu or cuda");
}

}  // namespace piae::cli
