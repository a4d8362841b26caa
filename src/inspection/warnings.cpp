#include "inspection/warnings.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "base/one_line.hpp"
#include "inspection/file_warnings.hpp"
#include "inspection/plausibility.hpp"
#include "inspection/warning_text.hpp"
#include "signal/described_split.hpp"
#include "spectra/floors.hpp"
#include "spectra/shown_speed.hpp"

namespace piae::inspection {

namespace {

using signal::DatasetInfo;
using signal::Description;
using signal::RecordSource;
using Lines = std::vector<std::string>;

constexpr std::size_t sensible_stride = 100;  // the paper's data have at least this

double turns_in(double seconds, double shaft_speed_rpm) { return seconds * shaft_speed_rpm / 60; }

std::string hz_hint(double rpm) {
  return fmt::format(
      " looks like Hz, which is {:g} rpm; if so, all fault frequencies are 60 times too low",
      rpm * 60);
}

/// Warns once for the data set's key, and once for each record with its own speed.
void add_speeds(const Description& description, Lines& lines) {
  const double common = description.info.shaft_speed_rpm;
  if (looks_like_hz(common)) {
    lines.push_back(fmt::format("shaft_speed_rpm = {:g}{}", common, hz_hint(common)));
  }
  for (const RecordSource& source : description.records) {
    if (source.shaft_speed_rpm == common || !looks_like_hz(source.shaft_speed_rpm)) continue;
    lines.push_back(fmt::format("{}: shaft_speed_rpm = {:g}{}", place_of(source),
                                source.shaft_speed_rpm, hz_hint(source.shaft_speed_rpm)));
  }
}

/// Warns of recorded speeds that are far from the described one: another unit, or other pulses.
void add_recorded_speeds(const Description& description, const std::vector<RecordCheck>& records,
                         Lines& lines) {
  constexpr double far = 1.5;
  const double common = description.info.shaft_speed_rpm;
  std::vector<const RecordCheck*> distant;
  for (const RecordCheck& record : records) {
    const double ratio = record.source.shaft_speed_rpm / common;
    const bool is_far = ratio > far || ratio < 1 / far;
    if (record.source.speed && record.problem.empty() && is_far) distant.push_back(&record);
  }
  const auto text = [&](const RecordCheck& record) {
    return fmt::format(
        "{}: its recorded speed is {:.5g} rpm in the mean, but shaft_speed_rpm = {:g} of the data "
        "set; is the channel in rpm, are times in s, and how many pulses_per_turn are there?",
        place_of(record.source), record.source.shaft_speed_rpm, common);
  };
  add_for_each(distant, text, lines);
}

/// Warns of suspect records whose lines cannot be named without a bearing.
void add_unnamed_lines(const Description& description, const std::vector<RecordCheck>& records,
                       Lines& lines) {
  if (description.info.has_bearing) return;
  const Label healthy = description.info.healthy_label();
  std::vector<const RecordCheck*> short_ones;
  bool any_named = false;
  for (const RecordCheck& record : records) {
    any_named = any_named || record.unknown_line.has_value();
    const bool is_measured = record.order_lines.size() > 0 || record.turns() < fewest_turns;
    if (record.source.label == healthy || !record.problem.empty() || is_measured) continue;
    short_ones.push_back(&record);
  }
  const auto text = [](const RecordCheck& record) {
    return fmt::format(
        "{}: {:.3g} turns of the shaft are too few to name its fault line without a [bearing]; "
        "use {:g} or more",
        place_of(record.source), record.turns(), fewest_turns_for_orders);
  };
  add_for_each(short_ones, text, lines);
  if (any_named && !std::filesystem::exists(description.bearing_table)) {
    lines.push_back(fmt::format(
        "{} is missing, so no bearing is named, and no line has a high confidence; copy "
        "pipeline/bearings.csv there",
        description.bearing_table.string()));
  }
}

/// Warns of records whose shaft shows another speed than the given one, unless that is taken.
void add_other_speeds(const Description& description, const std::vector<RecordCheck>& records,
                      Lines& lines) {
  if (description.speed_search_percent > 0) return;
  const auto other = [](const RecordCheck& record) {
    return spectra::other_speed(record.shaft, record.source.shaft_speed_rpm);
  };
  std::vector<const RecordCheck*> others;
  for (const RecordCheck& record : records) {
    if (!other(record).empty()) others.push_back(&record);
  }
  const auto text = [&](const RecordCheck& record) {
    return fmt::format(
        "{}: {} shaft_speed_rpm = {:g}, and so do all fault lines; correct it, or take speeds from "
        "the signals with speed_search_percent = {:g}",
        place_of(record.source), other(record), record.source.shaft_speed_rpm,
        spectra::speed_search_percent);
  };
  add_for_each(others, text, lines);
}

void add_raceways(const bearing::Geometry& g, Lines& lines) {
  const auto mismatch = raceway_mismatch(g);
  if (!mismatch) return;
  std::string what = "do not fit the pitch diameter";
  if (mismatch->too_wide) what = "look like bore and outside diameter";
  if (mismatch->too_tight) what = "look like the diameters of the shoulders next to the raceways";
  lines.push_back(fmt::format(
      "[bearing] inner_raceway_mm = {:g} and outer_raceway_mm = {:g} {}: half their difference is "
      "{:g} mm for a ball of {:g} mm, their mean {:g} mm for a pitch of {:g} mm; remove both keys "
      "to use {:g} and {:g}; the simulated contact and its stiffness depend on them",
      g.inner_raceway_mm, g.outer_raceway_mm, what, mismatch->gap_mm, g.ball_diameter_mm,
      mismatch->mean_mm, g.pitch_diameter_mm, g.pitch_diameter_mm - g.ball_diameter_mm,
      g.pitch_diameter_mm + g.ball_diameter_mm));
}

/// Warns if a window holds less than one turn at the slowest speed, or if the rate is too low for a
/// line at the fastest.
void add_rate(const Description& description, Lines& lines) {
  std::vector<RecordSource> sources = description.records;
  std::erase_if(sources, [](const RecordSource& s) { return looks_like_hz(s.shaft_speed_rpm); });
  if (sources.empty()) return;
  const auto [slowest, fastest] =
      std::ranges::minmax(sources, {}, [](const RecordSource& s) { return s.shaft_speed_rpm; });
  const DatasetInfo& info = description.info;
  const std::size_t window = signal::split_options_of(description).window;
  const double window_s = static_cast<double>(window) / info.sample_rate_hz;
  const double turns = turns_in(window_s, slowest.shaft_speed_rpm);
  if (turns < 1) {
    lines.push_back(fmt::format(
        "sample_rate_hz = {:g}: a window of {} samples ({:.3g} s) holds {:.2g} turns of the shaft "
        "at {:g} rpm ({}), so a window may miss what happens once a turn; lower the data set's "
        "rate for longer windows",
        info.sample_rate_hz, window, window_s, turns, slowest.shaft_speed_rpm, slowest.name));
  }
  if (!info.has_bearing) return;
  const FaultLines fault = fault_lines({}, info, fastest.shaft_speed_rpm);
  const double bpfi_hz = line_of(fault, signal::Defect::inner).hz;
  if (info.sample_rate_hz / 2 <= bpfi_hz) {
    lines.push_back(
        fmt::format("sample_rate_hz = {:g}: half of it does not reach BPFI, {:.4g} Hz at {:g} rpm "
                    "({}), so the impacts of a defect cannot be separated; is the rate in kHz?",
                    info.sample_rate_hz, bpfi_hz, fastest.shaft_speed_rpm, fastest.name));
  }
}

std::string length_at_rate(const RecordCheck& record) {
  return fmt::format("{}: {} samples at sample_rate_hz = {:g}", place_of(record.source),
                     record.file_samples, record.source.sample_rate_hz);
}

std::string too_long(const RecordCheck& record) {
  return fmt::format(
      "{} are {:.1f} hours, too long for one run at a constant speed; is the rate in kHz? The "
      "record is not resampled, and its lines are not measured",
      length_at_rate(record), record.length_s() / 3600);
}

std::string too_short(const RecordCheck& record) {
  const double piece_s = record.longest_piece_s();
  return fmt::format(
      "{} are {:.3g} s{}, {:.2g} turns of the shaft: fewer than {:g} do not show a fault line; is "
      "the rate "
      "too "
      "high?",
      length_at_rate(record), piece_s, record.files.size() > 1 ? " a file" : "", record.turns(),
      fewest_turns);
}

void add_lengths(const std::vector<RecordCheck>& records, Lines& lines) {
  std::vector<const RecordCheck*> long_ones;
  std::vector<const RecordCheck*> short_ones;
  for (const RecordCheck& record : records) {
    if (!record.problem.empty()) continue;
    const double rpm = record.source.shaft_speed_rpm;
    if (record.length_s() > longest_record_s) long_ones.push_back(&record);
    if (record.turns() < fewest_turns && !looks_like_hz(rpm)) {
      short_ones.push_back(&record);
    }
  }
  add_for_each(long_ones, too_long, lines);
  add_for_each(short_ones, too_short, lines);
}

/// Warns of records with a rate below the data set's.
void add_low_rates(const DatasetInfo& info, const std::vector<RecordCheck>& records, Lines& lines) {
  std::vector<const RecordCheck*> low;
  for (const RecordCheck& record : records) {
    const bool may_be_khz = record.length_s() > longest_record_s;  // already reported
    if (record.source.sample_rate_hz < info.sample_rate_hz && !may_be_khz) low.push_back(&record);
  }
  const auto text = [&](const RecordCheck& record) {
    const double rate_hz = record.source.sample_rate_hz;
    return fmt::format(
        "{}: sample_rate_hz = {:g} is below the data set's {:g}: nothing above {:g} Hz exists in "
        "this record, which alone distinguishes it from classes with a higher rate; set the data "
        "set's sample_rate_hz to {:g} or less",
        place_of(record.source), rate_hz, info.sample_rate_hz, rate_hz / 2, rate_hz);
  };
  add_for_each(low, text, lines);
}

/// Warns of records with a level above 200 times the healthy one, or below a 200th. Faults change
/// it less: up to 30 times in CWRU, 56 times in UESTC, and another three or four times at twice the
/// speed. Confused units change it more: converter counts or mg for g thousands of times,
/// millivolts of a usual sensor (100 mV/g) 100 times in addition to the fault.
void add_levels(const DatasetInfo& info, const std::vector<RecordCheck>& records, Lines& lines) {
  constexpr double most_times = 200;
  std::vector<double> healthy;
  for (const RecordCheck& record : records) {
    const bool is_healthy = info.class_of(record.source.label).defect == signal::Defect::none;
    if (is_healthy && record.level && !record.goes_one_way) healthy.push_back(record.level->rms);
  }
  if (healthy.empty()) return;
  const double usual = spectra::median(healthy);
  std::vector<const RecordCheck*> odd;
  for (const RecordCheck& record : records) {
    if (!record.level || record.goes_one_way || record.few_values) continue;
    const double times = record.level->rms / usual;
    if (times > most_times || times < 1 / most_times) odd.push_back(&record);
  }
  const auto text = [&](const RecordCheck& record) {
    const double times = record.level->rms / usual;
    return fmt::format(
        "{}: its RMS, {:.4g}, is {} times that of the healthy records, {:.4g}, but no fault "
        "changes it so much; one of them has another unit or scale, which features of the level "
        "would show instead of the fault",
        place_of(record.source), record.level->rms,
        times > 1 ? fmt::format("{:.0f}", times) : fmt::format("{:.2g}", times), usual);
  };
  add_for_each(odd, text, lines);
}

void add_stride(const Description& description, const ClassCheck& found, Lines& lines) {
  if (found.stride == 0 || found.stride >= sensible_stride) return;
  const std::size_t window = signal::split_options_of(description).window;
  lines.push_back(
      fmt::format("class {}: its recordings are so short that windows of {} samples start every {} "
                  "and overlap by {:.1f} %; with PROTOCOL=random {:.0f} % of the test windows (A) "
                  "share samples with a training window, so the accuracy says little about new "
                  "recordings; record longer, or use PROTOCOL=blocked",
                  description.info.class_of(found.label).name, window, found.stride,
                  100 * found.overlap, 100 * found.shared_with_training));
}

}  // namespace

std::vector<std::string> warnings_of(const Description& description, const DatasetCheck& check) {
  Lines lines;
  add_speeds(description, lines);
  if (description.info.has_bearing) add_raceways(description.info.bearing, lines);
  add_rate(description, lines);
  add_lengths(check.records, lines);
  add_low_rates(description.info, check.records, lines);
  for (const RecordCheck& record : check.records) add_odd_files(record, lines);
  for (const RecordCheck& record : check.records) {
    if (record.problem.empty())
      std::ranges::move(sample_warnings(record), std::back_inserter(lines));
  }
  add_levels(description.info, check.records, lines);
  add_other_speeds(description, check.records, lines);
  add_recorded_speeds(description, check.records, lines);
  add_unnamed_lines(description, check.records, lines);
  for (const ClassCheck& found : check.classes) add_stride(description, found, lines);
  std::ranges::move(line_warnings(description.info, check.records), std::back_inserter(lines));
  return lines;
}

std::vector<std::string> problems_of(const DatasetCheck& check) {
  Lines lines;
  for (const RecordCheck& record : check.records) {
    if (!record.problem.empty()) lines.push_back(one_line(record.problem));
  }
  for (const ClassCheck& each : check.classes) {
    if (!each.problem.empty()) lines.push_back(one_line(each.problem));
  }
  return lines;
}

}  // namespace piae::inspection
