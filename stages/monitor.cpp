// Classifies a stream of raw samples with a kept classifier, and raises an alarm.

#include <spdlog/spdlog.h>
#include <unistd.h>

#include "base/write_all.hpp"
#include "cli/interrupt.hpp"
#include "cli/stage.hpp"
#include "diagnosis/fitting_signal.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "monitor/watch.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

void write_to_standard_output(const std::string& text) {
  if (write_all(STDOUT_FILENO, std::as_bytes(std::span(text)))) return;
  throw Error(Exit::failed, "cannot write to standard output; redirect it to a file");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "monitor",
      "Classifies a stream of raw samples with a classifier that diagnose kept. Writes a line of "
      "JSON for each decision to standard output. Raises an alarm after the machine has looked "
      "faulty for long enough, and clears it after it has looked healthy again. Ends with its "
      "input, or on SIGTERM or Ctrl-C, with a line on standard error that reports the signal that "
      "was used and what was lost.",
      "monitor --classifier classifier.h5 --sample-rate-hz 12000 --speed-rpm 1797 < raw.f32");
  fs::path classifier_file;
  fs::path input_file = "-";
  bool follow = false;
  monitor::MonitorOptions options;
  monitor::WatchOptions watching;
  stage.input_file("--classifier", classifier_file,
                   "trained classifier, classifier.h5 of diagnose --keep-classifier");
  stage.input_file("--input", input_file, "raw samples; -: standard input").required(false);
  stage.file_flag("--follow", follow, "--input is a file that grows: wait for more at its end");
  bind(stage.options(), options);
  bind(stage.options(), watching);

  return stage.run(argc, argv, [&] {
    diagnosis::KeptClassifier classifier(stage.open("classifier", classifier_file, "classifier"));
    monitor::Input input(input_file, follow);
    diagnosis::require_fitting_signal(classifier.classifier(), classifier.info(),
                                      options.sample_rate_hz, options.speed_rpm, input.name());
    const auto predict = [&](const signal::WindowSet& windows) {
      return classifier.predict(windows);
    };
    monitor::Monitor monitor(classifier.info(), classifier.length(), predict, options,
                             input.name());
    cli::catch_interrupts();
    const std::string summary = watch(input, monitor, classifier.info(), watching, cli::interrupted,
                                      write_to_standard_output);
    spdlog::info(summary);
  });
}
