#include "inspection/check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "inspection/plausibility.hpp"
#include "inspection/spectrum_panel.hpp"
#include "signal/described_split.hpp"
#include "signal/estimated_speeds.hpp"
#include "signal/even_angle.hpp"
#include "signal/split.hpp"
#include "signal/stride.hpp"

namespace piae::inspection {

namespace {

using signal::Description;

void note_exit(DatasetCheck& check, Exit exit) {
  if (check.exit != Exit::bad_input) check.exit = exit;
}

void look_at_signal(RecordCheck& found, const signal::Record& record,
                    const signal::DatasetInfo& info) {
  const std::vector<double>& signal = record.signal;
  const double rate_hz = info.sample_rate_hz;
  found.pieces = record.piece_lengths();
  if (std::ranges::min(signal) < std::ranges::max(signal)) found.level = level_of(signal);
  if (record.speeds) {
    found.source.shaft_speed_rpm = record.shaft_speed_rpm;
  } else {
    found.shaft = spectra::estimate_shaft_speed(signal::longest_piece(record.signal, found.pieces),
                                                rate_hz, found.source.shaft_speed_rpm);
  }
  const bool is_tracked = record.speeds && found.pieces.size() == 1;
  const std::vector<double> tracked =
      is_tracked ? at_even_angle(signal, rate_hz, *record.speeds) : std::vector<double>();
  const std::vector<double>& even = is_tracked ? tracked : signal;
  if (!info.has_bearing) {
    found.order_lines = order_lines_db(signal::longest_piece(even, found.pieces), rate_hz,
                                       found.shown_speed_rpm() / 60);
  }
  found.envelope =
      envelope_spectrum(even, rate_hz, found.source.shaft_speed_rpm / 60, found.pieces);
  found.lines = fault_lines(found.envelope, info, found.source.shaft_speed_rpm);
  const auto shown = std::min(signal.size(), static_cast<std::size_t>(shown_s * rate_hz));
  found.beginning.assign(signal.begin(), signal.begin() + static_cast<std::ptrdiff_t>(shown));
  keep_shown_part(found.envelope, found.lines, found.source.shaft_speed_rpm / 60);
}

void look_for_flaws(RecordCheck& found, std::span<const double> samples) {
  found.goes_one_way = goes_one_way(samples);
  found.clipped = clipped_peaks(samples);
  found.held = held_values(samples);
  found.few_values = few_values(samples);
  found.cut_tops = cut_tops(samples);
  found.lone = lone_samples(samples);
  found.repeats = repeats(samples);
}

void look_at_record(RecordCheck& found, const Description& description,
                    signal::RecordReader& reader) {
  signal::RawRecord raw = reader.read_raw(found.source);
  const signal::DatasetInfo& info = description.info;
  found.file_samples = raw.samples.size();
  look_for_flaws(found, raw.samples);
  for (std::size_t i = 0; i < raw.files.size(); ++i) {
    const raw::Piece& piece = raw.pieces[i];
    found.files.push_back({.name = raw.files[i].name,
                           .samples = piece.samples,
                           .columns = piece.columns,
                           .times = piece.times,
                           .may_be_cut = piece.may_be_cut != 0});
  }
  if (found.length_s() > longest_record_s) {
    constexpr double most = 1e15;  // beyond any record, but still fits a sample count
    found.pieces = {
        static_cast<std::size_t>(std::min(most, found.length_s() * info.sample_rate_hz))};
    found.lines = fault_lines({}, info, found.source.shaft_speed_rpm);
  } else {
    look_at_signal(found, reader.resampled(found.source, std::move(raw)), info);
  }
}

/// Names the lines of all suspect records without knowing the bearing.
void look_for_unknown_lines(DatasetCheck& check, const Description& description) {
  const Label healthy = description.info.healthy_label();
  const auto known = signal::lines_of_bearings(description.bearing_table);
  for (RecordCheck& record : check.records) {
    if (record.source.label == healthy || record.order_lines.size() == 0) continue;
    const RecordCheck* const reference = healthy_record_for(record, check, healthy);
    if (reference == nullptr) continue;
    const OrderExcess excess(record.order_lines, reference->order_lines,
                             record.shown_speed_rpm() / 60);
    record.unknown_line = unknown_line(excess, record.shaft && record.shaft->is_certain(), known);
  }
}

/// True if all records of the class are readable. An unreadable record reports its own problem.
bool are_readable(const DatasetCheck& check, Label label) {
  return std::ranges::none_of(check.records, [&](const RecordCheck& record) {
    return record.source.label == label && !record.problem.empty();
  });
}

/// Returns class, condition and speed of each record.
std::vector<signal::RecordPlace> places_of(const Description& description,
                                           const DatasetCheck& check) {
  std::vector<signal::RecordPlace> places;
  for (const RecordCheck& record : check.records) {
    const signal::RecordSource& source = record.source;
    places.push_back({.label = source.label,
                      .condition = description.info.condition_called(source.condition),
                      .shaft_speed_rpm = source.shaft_speed_rpm});
  }
  return places;
}

/// Adds the results of a split for one source of a class. Throws as largest_stride().
void look_at_source(const signal::Source& source, const DatasetCheck& check,
                    const signal::SplitOptions& split, const std::string& name,
                    ClassCheck& result) {
  std::vector<std::size_t> lengths;
  for (const std::size_t i : source.records) {
    std::ranges::copy(check.records[i].pieces, std::back_inserter(lengths));
  }
  const std::size_t stride = signal::largest_stride(name, lengths,
                                                    {.window = split.window,
                                                     .max_stride = split.max_stride,
                                                     .windows = source.windows(),
                                                     .blocks = 0,
                                                     .guard = 0});
  if (result.stride == 0 || stride < result.stride) result.stride = stride;
  const std::size_t tested = source.count_of(signal::Role::test);
  const std::size_t training =
      source.count_of(signal::Role::healthy) + source.count_of(signal::Role::known);
  result.shared_with_training +=
      static_cast<double>(tested) / static_cast<double>(split.test_per_class) *
      share_that_meets_training(stride, split.window, source.windows(), training);
}

ClassCheck check_class(const Description& description, const DatasetCheck& check, Label label) {
  ClassCheck result{.label = label};
  result.records = static_cast<std::size_t>(std::ranges::count(
      check.records, label, [](const RecordCheck& record) { return record.source.label; }));
  if (!are_readable(check, label)) return result;
  const signal::SplitOptions split = signal::split_options_of(description);
  const signal::DatasetInfo& info = description.info;
  try {
    const Stream any("check");
    for (const signal::Source& source :
         sources_of(info, label, places_of(description, check), counts_of(split), any)) {
      look_at_source(source, check, split, name_of(info, label, source), result);
    }
  } catch (const Error& error) {
    return {.label = label, .records = result.records, .problem = error.what()};
  }
  result.overlap = 1 - static_cast<double>(result.stride) / static_cast<double>(split.window);
  return result;
}

}  // namespace

double RecordCheck::longest_piece_s() const {
  if (files.empty()) return length_s();
  const std::size_t most = std::ranges::max(files, {}, &FileCheck::samples).samples;
  return static_cast<double>(most) / source.sample_rate_hz;
}

double RecordCheck::shown_speed_rpm() const {
  return shaft && shaft->is_certain() ? shaft->rpm : source.shaft_speed_rpm;
}

const RecordCheck* healthy_record_for(const RecordCheck& suspect, const DatasetCheck& check,
                                      Label healthy) {
  const auto distance = [&](const RecordCheck& other) {
    const bool is_same = other.source.condition == suspect.source.condition;
    return std::pair(!is_same, std::abs(other.shown_speed_rpm() / suspect.shown_speed_rpm() - 1));
  };
  const RecordCheck* best = nullptr;
  for (const RecordCheck& record : check.records) {
    if (record.source.label != healthy || record.order_lines.size() == 0) continue;
    if (best == nullptr || distance(record) < distance(*best)) best = &record;
  }
  return best;
}

DatasetCheck check(const Description& description, const std::filesystem::path& data_dir,
                   const signal::RecordsDone& done) {
  DatasetCheck check;
  signal::RecordReader reader(description, data_dir);
  for (const signal::RecordSource& source : description.records) {
    RecordCheck found;
    found.source = source;
    try {
      look_at_record(found, description, reader);
    } catch (const Error& error) {
      found.problem = error.what();
      note_exit(check, error.exit());
    }
    check.records.push_back(std::move(found));
    if (done) done(check.records.size());
  }
  if (!description.info.has_bearing) look_for_unknown_lines(check, description);
  for (const Label label : description.info.labels()) {
    check.classes.push_back(check_class(description, check, label));
    if (!check.classes.back().problem.empty()) note_exit(check, Exit::bad_input);
  }
  return check;
}

}  // namespace piae::inspection
