#include "diagnosis/wdcnn_options.hpp"

namespace piae::diagnosis {

void bind(const cli::Options& command, WdcnnOptions& options) {
  command.add("--epochs", options.epochs, "passes over the training set")
      .check(cli::positive_number());
  command.add("--batch", options.batch, "windows in a batch, at least 2")
      .check(cli::number(">=2", "a number of at least 2", [](double x) { return x >= 2; }));
  command.add("--learning-rate", options.learning_rate, "learning rate of Adam")
      .check(cli::positive_number());
}

}  // namespace piae::diagnosis
