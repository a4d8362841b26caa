#include "cli/run_options.hpp"

namespace piae::cli {

void bind(const cli::Options& command, RunOptions& options) {
  command.add("--seed", options.seed, "the repeat; names the random streams")
      .required()
      .check(natural_number());
  command.choose("--device", options.compute.device, {{"cpu", Device::cpu}, {"cuda", Device::cuda}},
                 "cpu or cuda, for networks");
  command.choose(
      "--backend", options.compute.backend,
      {{"auto", Backend::automatic}, {"native", Backend::native}, {"libtorch", Backend::libtorch}},
      "what computes networks: native (one core, the fastest), libtorch, or auto: "
      "native where it can be");
}

}  // namespace piae::cli
