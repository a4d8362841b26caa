#include "cli/run_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/numbers.hpp"

namespace piae::cli {

void bind(CLI::App& app, RunOptions& options) {
  app.add_option("--seed", options.seed, "the repeat; names the random streams")
      ->required()
      ->check(natural_number());
  app.add_option("--device", options.device, "cpu or cuda");
}

}  // namespace piae::cli
