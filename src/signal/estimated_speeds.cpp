#include "signal/estimated_speeds.hpp"

#include <algorithm>

#include "signal/described_conditions.hpp"
#include "spectra/shaft_speed.hpp"

namespace piae::signal {

std::span<const double> longest_piece(std::span<const double> signal,
                                      const std::vector<std::size_t>& lengths) {
  std::span<const double> longest;
  std::size_t first = 0;
  for (const std::size_t length : lengths) {
    if (length > longest.size()) longest = signal.subspan(first, length);
    first += length;
  }
  return longest;
}

bool reads_for_speed(const Description& description, const RecordSource& source) {
  return description.speed_search_percent > 0 || source.speed.has_value();
}

EstimatedSpeeds use_speeds_of_signals(Description& description,
                                      const std::filesystem::path& data_dir,
                                      const std::function<void()>& record_done) {
  EstimatedSpeeds speeds;
  const auto reads = [&](const RecordSource& source) {
    return reads_for_speed(description, source);
  };
  if (std::ranges::none_of(description.records, reads)) return speeds;
  RecordReader reader(description, data_dir);
  for (RecordSource& source : description.records) {
    if (!reads(source)) continue;
    const Record record = reader.read(source);
    record_done();
    if (record.speeds) {
      source.shaft_speed_rpm = record.shaft_speed_rpm;
      continue;
    }
    const auto shaft =
        spectra::estimate_shaft_speed(longest_piece(record.signal, record.piece_lengths()),
                                      description.info.sample_rate_hz, source.shaft_speed_rpm);
    const bool shows =
        shaft && shaft->is_within(description.speed_search_percent, source.shaft_speed_rpm);
    if (!shows) continue;
    const double ratio = shaft->rpm / source.shaft_speed_rpm;
    speeds.lowest = speeds.found == 0 ? ratio : std::min(speeds.lowest, ratio);
    speeds.highest = speeds.found == 0 ? ratio : std::max(speeds.highest, ratio);
    ++speeds.found;
    source.shaft_speed_rpm = shaft->rpm;
  }
  for (Condition& condition : description.info.conditions) {
    condition.shaft_speed_rpm = mean_speed_of_records_rpm(description.records, condition.name);
  }
  return speeds;
}

}  // namespace piae::signal
