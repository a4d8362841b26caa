// Classifies a stream of raw samples with a kept classifier, or compares it with its healthy hours,
// and raises an alarm.

#include "monitor/monitor.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include "base/write_all.hpp"
#include "cli/interrupt.hpp"
#include "cli/stage.hpp"
#include "diagnosis/fitting_signal.hpp"
#include "diagnosis/kept_classifier.hpp"
#include "monitor/watch.hpp"
#include "trend/sources.hpp"
#include "trend/trend_monitor.hpp"

using namespace piae;
namespace fs = std::filesystem;

namespace {

void write_to_standard_output(const std::string& text) {
  if (write_all(STDOUT_FILENO, std::as_bytes(std::span(text)))) return;
  throw Error(Exit::failed, "cannot write to standard output; redirect it to a file");
}

/// Options of the stage.
struct Settings {
  fs::path classifier;
  fs::path input = "-";
  bool follow = false;
  monitor::MonitorOptions options;
  monitor::WatchOptions watching;
  trend::Sources sources;
};

std::string follow(monitor::Input& input, monitor::StreamMonitor& stream,
                   const Settings& settings) {
  cli::catch_interrupts();
  return monitor::watch(input, stream, settings.watching, cli::interrupted,
                        write_to_standard_output);
}

void warn(const std::string& line) { spdlog::warn(line); }

void classify_stream(cli::Stage& stage, const Settings& settings) {
  const monitor::MonitorOptions& options = settings.options;
  require_given(options);
  diagnosis::KeptClassifier classifier(stage.open("classifier", settings.classifier, "classifier"));
  monitor::Input input(settings.input, settings.follow);
  diagnosis::require_fitting_signal(classifier.classifier(), classifier.info(),
                                    options.sample_rate_hz, options.speed_rpm, input.name());
  const auto predict = [&](const signal::WindowSet& windows) {
    return classifier.predict(windows);
  };
  const auto fits = [&](double rpm) {
    return diagnosis::is_fitting_speed(classifier.classifier(), classifier.info(), rpm);
  };
  monitor::Monitor monitor(classifier.info(), classifier.length(), predict, options, input.name(),
                           {.fits = fits, .say = warn});
  spdlog::info(follow(input, monitor, settings));
}

/// Returns the search for the speed at which the fault lines lie.
monitor::SpeedSearch search_of_lines(trend::Session& session,
                                     const monitor::MonitorOptions& options) {
  const std::optional<trend::Lines>& lines = session.trend().meter().lines();
  if (!lines && options.speed_search_percent > 0) {
    throw Error(Exit::usage,
                "--speed-search-percent needs fault lines: give --description and --speed-rpm, and "
                "windows that show them (--window-s)");
  }
  return search_of(options, lines ? lines->speed_rpm : 0, {.say = warn});
}

void watch_trend_of_stream(cli::Stage& stage, const Settings& settings) {
  const monitor::MonitorOptions& options = settings.options;
  monitor::Input input(settings.input, settings.follow);
  if (settings.input != "-") stage.note_read(settings.input);
  trend::Session session =
      session_of_stream(stage, settings.sources,
                        {options.sample_rate_hz, options.speed_rpm, options.every_s}, input.name());
  trend::TrendMonitor monitor(session.trend(), options.format, input.name(), session.remember(),
                              search_of_lines(session, options));
  const std::string summary = follow(input, monitor, settings);
  if (!cli::interrupted()) session.require_baseline();
  save(stage, settings.sources, session);
  spdlog::info(summary + session.first_alarm());
}

void watch_trend_of_record(cli::Stage& stage, const Settings& settings) {
  if (settings.options.speed_search_percent > 0) {
    throw Error(Exit::usage,
                "--speed-search-percent is for streams: ingest finds the speeds of records "
                "(speed_search_percent of their description)");
  }
  trend::Session session = session_of_record(stage, settings.sources);
  session.watch_record(write_to_standard_output);
  session.require_baseline();
  save(stage, settings.sources, session);
  spdlog::info(session.summary() + session.first_alarm());
}

}  // namespace

int main(int argc, char** argv) {
  cli::Stage stage(
      "monitor",
      "Classifies a stream of raw samples with a classifier that diagnose kept, or compares it "
      "with its own first hours (--healthy). Writes a line of JSON for each decision to standard "
      "output. Raises an alarm after the machine has looked faulty for long enough, and clears it "
      "after it has looked healthy again. Ends with its input, or on SIGTERM or Ctrl-C, with a "
      "line on standard error that reports the signal that was used and what was lost.",
      "monitor --classifier classifier.h5 --sample-rate-hz 12000 --speed-rpm 1797 < raw.f32");
  Settings settings;
  stage
      .input_file("--classifier", settings.classifier,
                  "trained classifier, classifier.h5 of diagnose --keep-classifier")
      .required(false);
  stage.input_file("--input", settings.input, "raw samples; -: standard input").required(false);
  stage.file_flag("--follow", settings.follow,
                  "--input is a file that grows: wait for more at its end");
  bind(stage.options(), settings.options);
  bind(stage.options(), settings.watching);
  bind(stage, settings.sources);

  return stage.run(argc, argv, [&] {
    require_possible(settings.sources, !settings.classifier.empty());
    if (!settings.classifier.empty()) return classify_stream(stage, settings);
    if (!settings.sources.records.empty()) return watch_trend_of_record(stage, settings);
    watch_trend_of_stream(stage, settings);
  });
}
