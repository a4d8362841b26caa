#include "cli/run_options.hpp"

namespace piae::cli {

void bind(const cli::Options& command, RunOptions& options) {
  command.add("--seed", options.seed, "number of the repeat; selects the random streams")
      .required()
      .check(natural_number());
  bind(command, options.compute);
}

void bind(const cli::Options& command, Compute& compute) {
  command.choose("--device", compute.device, {{"cpu", Device::cpu}, {"cuda", Device::cuda}},
                 "device for networks: cpu or cuda");
  command.choose(
      "--backend", compute.backend,
      {{"auto", Backend::automatic}, {"native", Backend::native}, {"libtorch", Backend::libtorch}},
      "back end for networks: native (one core, fastest), libtorch, or auto (native if possible)");
}

}  // namespace piae::cli
