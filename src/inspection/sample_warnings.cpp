#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "inspection/warning_text.hpp"
#include "inspection/warnings.hpp"
#include "raw/times.hpp"

namespace piae::inspection {

namespace {

using Lines = std::vector<std::string>;

double percent(std::size_t part, std::size_t whole) {
  return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

/// Reports clipped stretches if there are any, because they say more than single samples; otherwise
/// reports single clipped samples.
void add_clipped(const RecordCheck& record, const std::string& place, Lines& lines) {
  const Stretches& clipped = record.clipped;
  if (clipped.count > 0) {
    lines.push_back(fmt::format(
        "{}: clipped: {} samples in {} stretches are flat at the highest or lowest value (the "
        "longest: {} samples at {:g} from {}); the impacts that show a fault are cut off",
        place, clipped.samples, clipped.count, clipped.longest, clipped.value,
        sample_text(record, clipped.longest_first)));
    return;
  }
  const CutTops& cut = record.cut_tops;
  if (cut.samples() == 0) return;
  std::string values;
  if (cut.on_highest > 0) values = fmt::format("the highest value ({:g})", cut.highest);
  if (cut.on_lowest > 0) {
    values += fmt::format("{}the lowest ({:g})", values.empty() ? "" : " or ", cut.lowest);
  }
  lines.push_back(
      fmt::format("{}: clipped: {} samples, {:.3g} % of the record, lie exactly on {}, more than "
                  "unclipped peaks would leave there; the impacts that show a fault are cut off",
                  place, cut.samples(), percent(cut.samples(), record.file_samples), values));
}

void add_held(const RecordCheck& record, const std::string& place, Lines& lines) {
  const Stretches& held = record.held;
  if (held.count == 0) return;
  lines.push_back(
      fmt::format("{}: constant at {:g} for {} samples ({:.3g} s) from {}; {} such stretch{}, "
                  "{:.3g} % of the record; windows from there do not show vibration",
                  place, held.value, held.longest,
                  static_cast<double>(held.longest) / record.source.sample_rate_hz,
                  sample_text(record, held.longest_first), held.count, held.count == 1 ? "" : "es",
                  percent(held.samples, record.file_samples)));
}

void add_lone(const RecordCheck& record, const std::string& place, Lines& lines) {
  const LoneSamples& lone = record.lone;
  if (lone.count == 0) return;
  const std::string more = lone.count == 1
                               ? " is an isolated spike"
                               : fmt::format(" and {} more are isolated spikes", lone.count - 1);
  lines.push_back(
      fmt::format("{}: {} ({:g}){} from the converter or cable: the neighbours are normal, "
                  "and no other sample is farther than {:.3g} from the mean; a spike sets the "
                  "level of its window, so replace it by the mean of its neighbours",
                  place, sample_text(record, lone.farthest), lone.value, more, lone.others));
}

void add_repeats(const RecordCheck& record, const std::string& place, Lines& lines) {
  const Repeats& found = record.repeats;
  if (found.count == 0) return;
  const std::string more =
      found.count == 1 ? "" : fmt::format(" (the longest of {} such stretches)", found.count);
  lines.push_back(fmt::format(
      "{}: {} repeat {} exactly{}, {:.3g} % of the record; test "
      "windows then equal training windows, even with PROTOCOL=blocked; cut the file there",
      place, samples_text(record, found.first, found.first + found.longest - 1),
      samples_text(record, found.original, found.original + found.longest - 1), more,
      percent(found.samples, record.file_samples)));
}

std::string times_text(std::size_t count) {
  return count == 1 ? "1 time" : fmt::format("{} times", count);
}

/// Adds a warning of missing samples in the files of a record.
void add_dropouts(const RecordCheck& record, const std::string& place, Lines& lines) {
  raw::Times found;
  std::size_t before = 0;  // samples of the previous files
  for (const FileCheck& file : record.files) {
    const raw::Times times =
        raw::are_rounded(file.times, record.source.sample_rate_hz) ? raw::Times{} : file.times;
    found.gaps += times.gaps;
    found.missing += times.missing;
    if (times.longest > found.longest) {
      found.column = times.column;
      found.longest = times.longest;
      found.longest_after = before + times.longest_after;
    }
    before += file.samples;
  }
  if (found.gaps == 0) return;
  lines.push_back(fmt::format(
      "{}: the times in column {} jump {}: {} sample{} missing; the longest gap, of {}, follows "
      "{}; a window across a gap is not continuous; cut the file there",
      place, found.column, times_text(found.gaps), found.missing,
      found.missing == 1 ? " is" : "s are", found.longest,
      sample_text(record, found.longest_after)));
}

/// Adds a warning if times go back: the file holds several recordings one after another.
void add_steps_back(const RecordCheck& record, const std::string& place, Lines& lines) {
  const auto file = std::ranges::find_if(
      record.files, [](const FileCheck& one) { return one.times.steps_back > 0; });
  if (file == record.files.end()) return;
  lines.push_back(
      fmt::format("{}: the times in column {}{} go back {}, first after sample {}: several "
                  "recordings seem to follow each other; cut the file there",
                  place, file->times.column, of_file(record, *file),
                  times_text(file->times.steps_back), file->times.first_back_after));
}

/// Adds a warning if times step unevenly.
void add_uneven(const RecordCheck& record, const std::string& place, Lines& lines) {
  const auto file =
      std::ranges::find_if(record.files, [](const FileCheck& one) { return one.times.is_uneven; });
  if (file == record.files.end()) return;
  lines.push_back(
      fmt::format("{}: the times in column {}{} step unevenly, by {:.3g} on average; spectra of "
                  "such samples are wrong; record at a constant rate, or resample to one",
                  place, file->times.column, of_file(record, *file), file->times.mean_step));
}

/// Adds a warning if a file may end within a number.
void add_cut_end(const RecordCheck& record, const std::string& place, Lines& lines) {
  const auto file = std::ranges::find_if(record.files, &FileCheck::may_be_cut);
  if (file == record.files.end()) return;
  lines.push_back(fmt::format(
      "{}: the last number{} has no line end and is shorter than 95 % of the others, so the file "
      "may be cut off; get it again, or remove its last line",
      place, of_file(record, *file)));
}

/// Adds a warning if the times contradict sample_rate_hz. Even times with a known unit do not get
/// here, because reading the file refuses them.
void add_other_rate(const RecordCheck& record, const std::string& place, Lines& lines) {
  const double stated_hz = record.source.sample_rate_hz;
  if (record.length_s() > longest_record_s) return;  // already reported as a rate in kHz
  for (const FileCheck& file : record.files) {
    const raw::Times& times = file.times;
    const auto other = raw::contradicting_rate(times, stated_hz);
    if (!other) continue;
    lines.push_back(fmt::format(
        "{}: the times in column {}{} step by {:.5g}, {} {:.5g} Hz in {}, but sample_rate_hz = "
        "{:g}; all fault frequencies are off by that factor; correct the times or the rate",
        place, times.column, of_file(record, file), times.step > 0 ? times.step : times.mean_step,
        times.unit_s > 0 ? "which is" : "which would be", other->hz, raw::unit_name(other->unit_s),
        stated_hz));
    return;
  }
}

}  // namespace

std::vector<std::string> sample_warnings(const RecordCheck& record) {
  const std::string place = place_of(record.source);
  if (record.goes_one_way) {
    return {place +
            ": the samples only rise or only fall, so they are a time or a counter, not an "
            "acceleration; name "
            "another variable"};
  }
  if (record.few_values) {
    return {
        fmt::format("{}: has only {} distinct values; the sensor is dead, or the gain is so low "
                    "that rounding hides the vibration",
                    place, *record.few_values)};
  }
  Lines lines;
  add_clipped(record, place, lines);
  add_held(record, place, lines);
  add_lone(record, place, lines);
  add_repeats(record, place, lines);
  add_dropouts(record, place, lines);
  add_steps_back(record, place, lines);
  add_uneven(record, place, lines);
  add_other_rate(record, place, lines);
  add_cut_end(record, place, lines);
  return lines;
}

}  // namespace piae::inspection
