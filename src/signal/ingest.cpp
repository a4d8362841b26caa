#include "signal/ingest.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "raw/file.hpp"
#include "raw/limits.hpp"
#include "signal/resample.hpp"

namespace piae::signal {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_record(const fs::path& file, const RecordSource& source,
                                const std::string& what) {
  throw Error(Exit::bad_input, file.string() + " (record " + source.name + "): " + what);
}

void require_file(const fs::path& file, const RecordSource& source, const std::string& dataset) {
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) return;
  const std::string what =
      fs::exists(fs::symlink_status(file, ignored)) ? "is not a file" : "no such file";
  throw Error(Exit::input_missing,
              file.string() + ": " + what + "; record " + source.name + " of dataset " + dataset +
                  " needs it: run `make data`, or name the folder that holds " + source.file +
                  " by DATA_DIR= (--data-dir)");
}

/// The file's sha256, which must be the declared one where there is one.
std::string checked_sha256(const fs::path& file, const RecordSource& source) {
  std::string found = sha256_of_file(file);
  if (!source.sha256.empty() && source.sha256 != found) {
    refuse_record(file, source,
                  "sha256 is " + found + ", expected " + source.sha256 +
                      "; the file is damaged or another one, fetch it again");
  }
  return found;
}

void require_usable(const fs::path& file, const RecordSource& source,
                    std::span<const double> signal) {
  if (signal.empty()) refuse_record(file, source, source.variable + " holds no sample");
  const auto odd = std::ranges::find_if_not(
      signal, [](double x) { return std::isfinite(static_cast<float>(x)); });
  if (odd != signal.end()) {
    refuse_record(file, source,
                  source.variable + " is NaN, infinite or beyond 32 bits at sample " +
                      std::to_string(odd - signal.begin()) + " (counted from 0)");
  }
  const auto [low, high] = std::ranges::minmax(signal);
  if (low == high) refuse_record(file, source, source.variable + " never changes: a dead channel");
}

}  // namespace

RecordReader::RecordReader(const Description& description, fs::path data_dir)
    : info_(description.info), data_dir_(std::move(data_dir)) {}

void RecordReader::require_new(const fs::path& file, const RecordSource& source,
                               std::span<const double> signal) {
  const std::string digest = Sha256().update(std::as_bytes(signal)).finish();
  const auto [place, is_new] = read_before_.emplace(digest, source);
  if (is_new) return;
  const RecordSource& twin = place->second;
  refuse_record(
      file, source,
      "holds the same samples as record " + twin.name + " (" + twin.file +
          (twin.label == source.label ? "); name each recording once" : "), under another class"));
}

RawRecord RecordReader::read_raw(const RecordSource& source) {
  const fs::path file = data_dir_ / source.file;
  require_file(file, source, info_.name);
  (void)raw::limits_of(file);  // which refuses what is too large, before all of that is hashed
  RawRecord raw;
  raw.sha256 = checked_sha256(file, source);
  raw.samples = raw::read(file, source.variable, source.sample_rate_hz);
  require_usable(file, source, raw.samples);
  require_new(file, source, raw.samples);
  return raw;
}

Record RecordReader::resampled(const RecordSource& source, const RawRecord& raw) const {
  constexpr double most_samples = 1e8;
  const double samples =
      static_cast<double>(raw.samples.size()) * info_.sample_rate_hz / source.sample_rate_hz;
  if (samples > most_samples) {
    refuse_record(
        data_dir_ / source.file, source,
        "would have more than 1e8 samples at the dataset's rate; look at both sample rates");
  }
  std::vector<double> signal = resample(raw.samples, source.sample_rate_hz, info_.sample_rate_hz);
  if (signal.empty()) {
    refuse_record(data_dir_ / source.file, source,
                  "is shorter than one sample at the dataset's rate");
  }
  return {.name = source.name,
          .label = source.label,
          .original_sample_rate_hz = source.sample_rate_hz,
          .shaft_speed_rpm = source.shaft_speed_rpm,
          .source = source.file,
          .source_sha256 = raw.sha256,
          .signal = std::move(signal),
          .parameters = std::nullopt,
          .condition = info_.condition_called(source.condition),
          .defect_size_mm = source.defect_size_mm};
}

Recordings ingest(const Description& description, const fs::path& data_dir,
                  const RecordsDone& done) {
  Recordings recordings{description.info, {}};
  RecordReader reader(description, data_dir);
  for (const RecordSource& source : description.records) {
    recordings.records.push_back(reader.read(source));
    if (done) done(recordings.records.size());
  }
  return recordings;
}

}  // namespace piae::signal
