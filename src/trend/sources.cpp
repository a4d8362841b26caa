#include "trend/sources.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/range.hpp"
#include "signal/description.hpp"
#include "signal/ranges.hpp"
#include "text/file.hpp"
#include "trend/snapshots.hpp"

namespace piae::trend {

namespace {

constexpr Range window_s{.low = 0, .high = 600, .unit = " s"};

[[noreturn]] void refuse(const std::string& what) {
  throw Error(Exit::usage, what + " (see monitor --help)");
}

/// Windows of a signal that is about to be watched.
struct Signal {
  double sample_rate_hz = 0;
  std::size_t length = 0;
  std::optional<bearing::Geometry> bearing;
  double speed_rpm = 0;
};

FeatureMeter meter_of(const Signal& signal, const std::string& name) {
  std::optional<Lines> lines;
  if (signal.bearing) {
    lines = lines_shown(*signal.bearing, signal.speed_rpm, signal.sample_rate_hz, signal.length);
    if (!lines) {
      spdlog::warn(
          "{}: windows of {} samples do not show the fault lines at {:g} rpm; only levels are "
          "watched",
          name, signal.length, signal.speed_rpm);
    }
  }
  return {signal.sample_rate_hz, signal.length, lines};
}

Baseline open_baseline(cli::Stage& stage, const Sources& sources, double rate_hz) {
  Baseline baseline = read_baseline(stage.open("baseline", sources.baseline, "baseline"));
  if (baseline.meter.rate_hz() == rate_hz) return baseline;
  throw Error(Exit::bad_input,
              fmt::format("{}: is a baseline at {:g} Hz, but the signal has {:g} Hz; record a "
                          "baseline at that rate (--healthy, --keep-baseline)",
                          sources.baseline.string(), baseline.meter.rate_hz(), rate_hz));
}

std::optional<bearing::Geometry> bearing_of(cli::Stage& stage, const Sources& sources) {
  if (sources.description.empty()) return std::nullopt;
  const signal::Description description = signal::read_description(sources.description);
  stage.note_input("description", sources.description);
  if (!description.info.has_bearing) return std::nullopt;
  return description.info.bearing;
}

}  // namespace

void bind(cli::Stage& stage, Sources& sources) {
  constexpr Range hours{.low = 1e-6, .high = 1e5, .unit = " h"};
  stage.options()
      .add("--healthy", sources.healthy_h,
           "instead of a classifier: the first hours of the signal, h, which are healthy. Later "
           "windows are compared with them")
      .check(cli::within(hours));
  stage.input_file("--baseline", sources.baseline, "kept baseline instead of --healthy")
      .required(false);
  stage
      .input_file("--records", sources.records,
                  "records.h5 of ingest instead of a stream; snapshots count at their times")
      .required(false);
  stage.options().add("--record", sources.record, "with --records: its name, if there are several");
  stage
      .input_file("--description", sources.description,
                  "data set description (TOML) with the [bearing] of a stream: its fault lines "
                  "are watched, too")
      .required(false);
  stage.options()
      .add("--window-s", sources.window_s,
           "length of the compared windows, s; 0: 1 s, or a whole snapshot")
      .check(cli::within(window_s));
  stage.output_file("--keep-baseline", sources.keep_baseline, "baseline to write (HDF5)")
      .required(false);
  stage.output_file("--picture", sources.picture, "trend to draw (SVG)").required(false);
  bind(stage.options().in_group("Alarm of a trend"), sources.options);
}

void require_possible(const Sources& sources, bool has_classifier) {
  const int given = (has_classifier ? 1 : 0) + (sources.healthy_h > 0 ? 1 : 0) +
                    (sources.baseline.empty() ? 0 : 1);
  if (given != 1) refuse("exactly one of --classifier, --healthy and --baseline is required");
  const bool has_trend_only = !sources.records.empty() || !sources.record.empty() ||
                              !sources.description.empty() || !sources.picture.empty() ||
                              !sources.keep_baseline.empty() || sources.window_s > 0;
  if (has_classifier && has_trend_only) {
    refuse(
        "--records, --record, --description, --window-s, --keep-baseline and --picture need "
        "--healthy or --baseline");
  }
  if (!sources.record.empty() && sources.records.empty()) refuse("--record needs --records");
  if (!sources.records.empty() && !sources.description.empty()) {
    refuse("--description is for streams: records hold their bearing");
  }
  if (!sources.baseline.empty() && sources.window_s > 0) {
    refuse("--window-s needs --healthy: a baseline has windows of its own");
  }
}

Session session_of_stream(cli::Stage& stage, const Sources& sources, const StreamProperties& stream,
                          const std::string& name) {
  if (stream.sample_rate_hz <= 0) refuse("--sample-rate-hz is required");
  stage.require_free({sources.keep_baseline, sources.picture});
  if (!sources.baseline.empty()) {
    return {{open_baseline(stage, sources, stream.sample_rate_hz), sources.options, stream.every_s},
            name};
  }
  const std::optional<bearing::Geometry> bearing = bearing_of(stage, sources);
  if (bearing && stream.speed_rpm <= 0) refuse("--speed-rpm is required for fault lines");
  const double length_s = sources.window_s > 0 ? sources.window_s : 1;
  const FeatureMeter meter =
      meter_of({.sample_rate_hz = stream.sample_rate_hz,
                .length = static_cast<std::size_t>(std::llround(length_s * stream.sample_rate_hz)),
                .bearing = bearing,
                .speed_rpm = stream.speed_rpm},
               name);
  return {{meter, sources.options, sources.healthy_h, stream.every_s}, name};
}

Session session_of_record(cli::Stage& stage, const Sources& sources) {
  const signal::Recordings recordings =
      signal::read_recordings(stage.open("records", sources.records, "records"));
  stage.require_free({sources.keep_baseline, sources.picture});
  const signal::DatasetInfo& info = recordings.info;
  const signal::Record& record = record_called(recordings, sources.record);
  const double rate_hz = info.sample_rate_hz;
  const double every_s = record.snapshot_interval_s ? 0 : 1;
  const std::string name = info.name + " " + record.name;
  if (!sources.baseline.empty()) {
    Baseline baseline = open_baseline(stage, sources, rate_hz);
    (void)window_of(record, rate_hz, baseline.meter.window_s());  // refuses too short snapshots
    return {{std::move(baseline), sources.options, every_s}, name, record};
  }
  const FeatureMeter meter =
      meter_of({.sample_rate_hz = rate_hz,
                .length = window_of(record, rate_hz, sources.window_s),
                .bearing = info.has_bearing ? std::optional(info.bearing) : std::nullopt,
                .speed_rpm = record.shaft_speed_rpm},
               name);
  return {{meter, sources.options, sources.healthy_h, every_s}, name, record};
}

void save(cli::Stage& stage, const Sources& sources, const Session& session) {
  if (!session.has_baseline()) return;
  if (!sources.picture.empty()) text::save_all({{sources.picture, session.picture()}});
  if (sources.keep_baseline.empty()) return;
  artefact::Writer writer("baseline");
  session.write_baseline(writer);
  stage.save(writer, sources.keep_baseline);
}

}  // namespace piae::trend
