#include "diagnosis/wdcnn_options.hpp"

#include <CLI/CLI.hpp>
#include <limits>

#include "cli/numbers.hpp"

namespace piae::diagnosis {

namespace {

constexpr auto many = std::numeric_limits<std::int64_t>::max();

}  // namespace

void bind(CLI::App& app, WdcnnOptions& options) {
  app.add_option("--epochs", options.epochs, "passes over the training set")
      ->check(CLI::Range(std::int64_t{1}, many).description("POSITIVE"));
  app.add_option("--batch", options.batch, "windows a training step, at least 2")
      ->check(CLI::Range(std::int64_t{2}, many).description(">=2"));
  app.add_option("--learning-rate", options.learning_rate, "of Adam")
      ->check(cli::positive_number());
  app.add_option("--backend", options.backend,
                 "what computes the network: native (one core, the fastest), libtorch, or auto: "
                 "native on the cpu, libtorch on cuda");
}

}  // namespace piae::diagnosis
