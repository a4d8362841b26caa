#include "signal/ingest.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/sha256.hpp"
#include "raw/file.hpp"
#include "raw/limits.hpp"
#include "signal/measured_speed.hpp"
#include "signal/record_files.hpp"
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
  const bool is_there = fs::exists(fs::symlink_status(file, ignored));
  const std::string none =
      is_pattern(file.filename().string()) ? "matches no file" : "no such file";
  throw Error(Exit::input_missing,
              file.string() + ": " + (is_there ? "is not a file" : none) + "; record " +
                  source.name + " of data set " + dataset +
                  " needs it; run `make data`, or give the folder that holds " +
                  source.file_text() + " as DATA_DIR= (--data-dir)");
}

void require_expected_sha256(const fs::path& file, const RecordSource& source,
                             const std::vector<SourceFile>& files) {
  const std::string found = sha256_of(files);
  if (source.sha256.empty() || source.sha256 == found) return;
  refuse_record(file, source,
                "sha256 is " + found + ", expected " + source.sha256 +
                    "; the file is damaged or another version, download it again");
}

void require_finite(const fs::path& file, const RecordSource& source,
                    std::span<const double> signal) {
  const std::optional<std::size_t> beyond = first_beyond_32_bits(signal);
  if (!beyond) return;
  refuse_record(file, source,
                source.variable + " is NaN, infinite or beyond 32 bits at sample " +
                    std::to_string(*beyond) + " (counted from 0)");
}

/// Refuses snapshots that last longer than the time between their starts.
void require_apart(const fs::path& file, const RecordSource& source,
                   const std::vector<raw::Piece>& pieces) {
  if (!source.snapshot_interval_s) return;
  constexpr double rounding = 1 + 1e-9;
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double length_s = static_cast<double>(pieces[i].samples) / source.sample_rate_hz;
    if (length_s <= *source.snapshot_interval_s * rounding) continue;
    refuse_record(file, source,
                  fmt::format("file {} of {} lasts {:g} s, but the next one starts {:g} s after "
                              "it; correct snapshot_interval_s or sample_rate_hz",
                              i + 1, pieces.size(), length_s, *source.snapshot_interval_s));
  }
}

/// Converts samples of a record's file to the unit of the data set.
void scale(std::span<double> samples, const RecordSource& source, double unit_m_per_s2) {
  if (!source.unit_m_per_s2 && source.offset == 0) return;
  const double factor = source.unit_m_per_s2.value_or(unit_m_per_s2) / unit_m_per_s2;
  for (double& sample : samples) sample = (sample - source.offset) * factor;
}

}  // namespace

RecordReader::RecordReader(const Description& description, fs::path data_dir)
    : info_(description.info), data_dir_(std::move(data_dir)) {}

std::vector<std::string> RecordReader::require_files(const RecordSource& source) const {
  std::vector<std::string> names = files_of(source.files, data_dir_);
  for (const std::string& name : names) require_file(data_dir_ / name, source, info_.name);
  if (names.empty()) require_file(data_dir_ / source.files.front(), source, info_.name);
  return names;
}

void RecordReader::require_new(const RecordSource& source, std::span<const double> signal) {
  const std::string digest = Sha256().update(std::as_bytes(signal)).finish();
  const auto [place, is_new] = read_before_.emplace(digest, source);
  if (is_new) return;
  const RecordSource& twin = place->second;
  refuse_record(data_dir_ / source.file_text(), source,
                "holds the same samples as record " + twin.name + " (" + twin.file_text() +
                    (twin.label == source.label ? "); name each recording once"
                                                : "), but has another class; correct one of them"));
}

RawRecord RecordReader::read_raw(const RecordSource& source) {
  const fs::path all = data_dir_ / source.file_text();
  RawRecord raw;
  std::vector<fs::path> paths;
  for (const std::string& name : require_files(source)) {
    raw.files.push_back({.name = name, .sha256 = {}});
    paths.push_back(data_dir_ / name);
  }
  (void)raw::limits_of(paths);  // refuses too large files before hashing them
  for (SourceFile& file : raw.files) file.sha256 = sha256_of_file(data_dir_ / file.name);
  require_expected_sha256(all, source, raw.files);
  raw::Signals signals = raw::read_all(paths, source.variable, source.sample_rate_hz);
  std::span<const double> rest = signals.samples;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::size_t count = signals.pieces[i].samples;
    require_finite(paths[i], source, rest.first(count));
    rest = rest.subspan(count);
  }
  raw.samples = std::move(signals.samples);
  raw.pieces = std::move(signals.pieces);
  const auto [low, high] = std::ranges::minmax(raw.samples);
  if (low == high) {
    refuse_record(all, source,
                  source.variable + " never changes: the channel is dead; name another variable");
  }
  require_new(source, raw.samples);
  return raw;
}

Record RecordReader::resampled(const RecordSource& source, RawRecord raw) const {
  constexpr double most_samples = 1e8;
  const fs::path all = data_dir_ / source.file_text();
  const double samples =
      static_cast<double>(raw.samples.size()) * info_.sample_rate_hz / source.sample_rate_hz;
  if (samples > most_samples) {
    refuse_record(
        all, source,
        "would have more than 1e8 samples at the data set's rate; check both sample rates");
  }
  Record record{.name = source.name,
                .label = source.label,
                .original_sample_rate_hz = source.sample_rate_hz,
                .shaft_speed_rpm = source.shaft_speed_rpm,
                .source = source.file_text(),
                .source_sha256 = sha256_of(raw.files),
                .signal = {},
                .parameters = std::nullopt,
                .condition = info_.condition_called(source.condition),
                .defect_size_mm = source.defect_size_mm,
                .pieces = {},
                .snapshot_interval_s = source.snapshot_interval_s,
                .files = std::move(raw.files)};
  require_apart(all, source, raw.pieces);
  if (source.sample_rate_hz == info_.sample_rate_hz) {
    for (const raw::Piece& piece : raw.pieces) record.pieces.push_back(piece.samples);
    record.signal = std::move(raw.samples);
  } else {
    resample_pieces(source, raw, record);
  }
  scale(record.signal, source, info_.unit_m_per_s2);
  if (source.speed) add_speeds(*source.speed, record);
  return record;
}

void RecordReader::add_speeds(const SpeedSource& source, Record& record) const {
  RecordTimes times{.name = record.name, .sample_s = 1 / info_.sample_rate_hz};
  for (const SourceFile& file : record.files) times.files.push_back(data_dir_ / file.name);
  for (const std::size_t length : record.piece_lengths()) {
    times.piece_s.push_back(static_cast<double>(length) / info_.sample_rate_hz);
  }
  record.speeds = read_speed(source, data_dir_, times);
  record.shaft_speed_rpm = record.speed_rpm(0, record.signal.size(), info_.sample_rate_hz);
  if (source.file.empty()) return;
  record.files.push_back({.name = source.file, .sha256 = sha256_of_file(data_dir_ / source.file)});
}

void RecordReader::resample_pieces(const RecordSource& source, const RawRecord& raw,
                                   Record& record) const {
  std::span<const double> rest = raw.samples;
  for (const raw::Piece& piece : raw.pieces) {
    const std::vector<double> samples =
        resample(rest.first(piece.samples), source.sample_rate_hz, info_.sample_rate_hz);
    rest = rest.subspan(piece.samples);
    if (samples.empty()) {
      refuse_record(data_dir_ / source.file_text(), source,
                    "is shorter than one sample at the data set's rate");
    }
    record.pieces.push_back(samples.size());
    record.signal.insert(record.signal.end(), samples.begin(), samples.end());
  }
}

void ingest(const Description& description, const fs::path& data_dir,
            const std::function<void(const Record&)>& take) {
  RecordReader reader(description, data_dir);
  for (const RecordSource& source : description.records) take(reader.read(source));
}

}  // namespace piae::signal
