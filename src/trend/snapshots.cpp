#include "trend/snapshots.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/error.hpp"

namespace piae::trend {

namespace {

constexpr double default_window_s = 1;

/// A piece of a record.
struct PieceOfRecord {
  std::size_t first = 0;  ///< its first sample in the record
  std::size_t samples = 0;
  double start_s = 0;
};

/// Passes on the first window of a snapshot, or all of another piece.
void cut(const signal::Record& record, const PieceOfRecord& piece, double rate_hz,
         std::size_t length, const std::function<void(const TimedWindow&)>& take) {
  std::vector<float> window(length);
  for (std::size_t at = 0; at + length <= piece.samples; at += length) {
    const auto samples = std::span(record.signal).subspan(piece.first + at, length);
    std::ranges::transform(samples, window.begin(), [](double x) { return static_cast<float>(x); });
    TimedWindow timed{.start_s = piece.start_s + static_cast<double>(at) / rate_hz,
                      .samples = window};
    if (record.speeds) timed.speed_rpm = record.speed_rpm(piece.first + at, length, rate_hz);
    take(timed);
    if (record.snapshot_interval_s) return;
  }
}

}  // namespace

const signal::Record& record_called(const signal::Recordings& recordings, const std::string& name) {
  if (name.empty() && recordings.records.size() == 1) return recordings.records.front();
  const auto found = std::ranges::find(recordings.records, name, &signal::Record::name);
  if (found != recordings.records.end()) return *found;
  std::string names;
  for (const signal::Record& record : recordings.records) {
    names += (names.empty() ? "" : ", ") + record.name;
  }
  throw Error(Exit::bad_input, name.empty()
                                   ? "there are several records; choose one with --record: " + names
                                   : "does not have a record " + name + "; known: " + names);
}

std::size_t window_of(const signal::Record& record, double rate_hz, double window_s) {
  const std::vector<std::size_t> pieces = record.piece_lengths();
  const auto [shortest, longest] = std::ranges::minmax(pieces);
  const bool whole_snapshots = record.snapshot_interval_s && window_s == 0;
  const double wished_s = window_s == 0 ? default_window_s : window_s;
  const auto length =
      whole_snapshots ? shortest : static_cast<std::size_t>(std::llround(wished_s * rate_hz));
  if (length <= longest && length > 0) return length;
  throw Error(Exit::bad_input,
              fmt::format("record {}: its longest piece has {} samples, but a window has {}; use "
                          "shorter windows (--window-s)",
                          record.name, longest, length));
}

void for_each_window(const signal::Record& record, double rate_hz, std::size_t length,
                     const std::function<void(const TimedWindow&)>& take) {
  PieceOfRecord piece;
  for (const std::size_t samples : record.piece_lengths()) {
    piece.samples = samples;
    cut(record, piece, rate_hz, length, take);
    piece.start_s += record.snapshot_interval_s.value_or(static_cast<double>(samples) / rate_hz);
    piece.first += samples;
  }
}

}  // namespace piae::trend
