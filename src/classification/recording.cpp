#include "classification/recording.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/one_line.hpp"
#include "diagnosis/fitting_signal.hpp"
#include "raw/file.hpp"
#include "signal/amplitude.hpp"
#include "signal/even_angle.hpp"
#include "signal/ingest.hpp"
#include "signal/resample.hpp"

namespace piae::classification {

namespace {

void require_finite_samples(const std::vector<double>& samples, const std::string& what) {
  const std::optional<std::size_t> beyond = first_beyond_32_bits(samples);
  if (!beyond) return;
  throw Error(Exit::bad_input,
              fmt::format("{}: sample {} (counted from 0) is NaN, infinite or beyond 32 bits; cut "
                          "the recording before it",
                          what, *beyond));
}

/// `records` have names.
void require_records(const auto& records, const std::vector<std::string>& names,
                     const std::string& file) {
  for (const std::string& name : names) {
    const auto is_named = [&](const auto& record) { return record.name == name; };
    if (std::ranges::any_of(records, is_named)) continue;
    std::string there;
    for (const auto& record : records) there += " " + record.name;
    throw Error(Exit::usage,
                fmt::format("{} does not have a record '{}'; known:{}", file, name, there));
  }
}

/// Finds the speed of a recording, requires that it fits, and resamples it.
Recording fitting(Recording recording, double rate_hz, const Fit& fit, const std::string& what) {
  if (!recording.speeds) {
    recording.shaft =
        spectra::estimate_shaft_speed(recording.signal, rate_hz, recording.given_speed_rpm);
  }
  const bool shows = recording.shaft && recording.shaft->is_within(fit.speed_search_percent,
                                                                   recording.given_speed_rpm);
  recording.shaft_speed_rpm = shows ? recording.shaft->rpm : recording.given_speed_rpm;
  diagnosis::require_fitting_signal(fit.classifier, fit.trained, rate_hz, recording.shaft_speed_rpm,
                                    what);
  recording.signal = signal::resample(recording.signal, rate_hz, fit.trained.sample_rate_hz);
  return recording;
}

bool is_chosen(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::ranges::count(names, name) > 0;
}

}  // namespace

Recording read_lone_file(const LoneFile& lone, const Fit& fit) {
  const std::string what = lone.file.string();
  std::vector<double> samples = raw::read(lone.file, lone.variable, lone.sample_rate_hz);
  require_finite_samples(samples, what);
  return fitting({.name = one_line(lone.file.filename().string()),
                  .given_speed_rpm = lone.shaft_speed_rpm,
                  .true_class = "",
                  .signal = std::move(samples)},
                 lone.sample_rate_hz, fit, what);
}

Recording recording_of(const signal::Record& record, const signal::DatasetInfo& described,
                       const Fit& fit) {
  return fitting({.name = record.name,
                  .given_speed_rpm = record.shaft_speed_rpm,
                  .speeds = record.speeds,
                  .true_class = described.class_of(record.label).name,
                  .signal = record.signal},
                 described.sample_rate_hz, fit, "record " + record.name);
}

std::vector<Recording> read_described(const std::filesystem::path& file,
                                      const std::filesystem::path& data_dir,
                                      const std::vector<std::string>& names, const Fit& fit,
                                      const std::function<void(const signal::SourceFile&)>& note) {
  const signal::Description description = signal::read_description(file);
  const double own_search = description.speed_search_percent;
  const Fit own{.classifier = fit.classifier,
                .trained = fit.trained,
                .speed_search_percent = own_search > 0 ? own_search : fit.speed_search_percent};
  require_records(description.records, names, file.string());
  signal::RecordReader reader(description, data_dir);
  std::vector<Recording> recordings;
  for (const signal::RecordSource& source : description.records) {
    if (!is_chosen(names, source.name)) continue;
    const signal::Record record = reader.read(source);
    std::ranges::for_each(record.files, note);
    recordings.push_back(recording_of(record, description.info, own));
  }
  return recordings;
}

std::vector<Recording> read_recorded(const artefact::Reader& records,
                                     const std::vector<std::string>& names, const Fit& fit) {
  const signal::Recordings all = signal::read_recordings(records);
  require_records(all.records, names, records.path().string());
  std::vector<Recording> recordings;
  for (const signal::Record& record : all.records) {
    if (is_chosen(names, record.name)) {
      recordings.push_back(recording_of(record, all.info, fit));
    }
  }
  return recordings;
}

std::vector<double> signal_for_lines(const Recording& recording, double rate_hz) {
  return recording.speeds ? signal::at_even_angle(recording.signal, rate_hz, *recording.speeds)
                          : recording.signal;
}

signal::WindowSet windows_of(const Recording& recording, const signal::DatasetInfo& trained,
                             std::size_t length, std::size_t step) {
  if (recording.signal.size() < length) {
    throw Error(
        Exit::bad_input,
        fmt::format("{}: has {} samples at {:g} Hz, but a window of the classifier has {}; "
                    "make a longer recording",
                    recording.name, recording.signal.size(), trained.sample_rate_hz, length));
  }
  signal::WindowSet windows;
  windows.info = trained;
  windows.length = length;
  const std::size_t last = recording.signal.size() - length;
  for (std::size_t first = 0; first <= last; first += step) {
    const auto begin = recording.signal.begin() + static_cast<std::ptrdiff_t>(first);
    std::transform(begin, begin + static_cast<std::ptrdiff_t>(length),
                   std::back_inserter(windows.samples),
                   [](double sample) { return static_cast<float>(sample); });
    windows.first_sample.push_back(static_cast<std::int64_t>(first));
    windows.labels.push_back(trained.healthy_label());  // any label: classifiers do not read it
    if (signal::is_constant(windows.window(windows.size() - 1))) {
      const double from_s = static_cast<double>(first) / trained.sample_rate_hz;
      throw Error(Exit::bad_input,
                  fmt::format("{}: is constant from {:.3g} to {:.3g} s (a dead channel); cut that "
                              "stretch out",
                              recording.name, from_s,
                              from_s + static_cast<double>(length) / trained.sample_rate_hz));
    }
    windows.shaft_speed_rpm.push_back(
        recording.speeds ? recording.speeds->mean_rpm(first, length, trained.sample_rate_hz)
                         : recording.shaft_speed_rpm);
  }
  windows.condition.assign(windows.size(), signal::every_condition);
  return windows;
}

}  // namespace piae::classification
