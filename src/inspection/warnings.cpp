#include "inspection/warnings.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "inspection/plausibility.hpp"
#include "signal/described_split.hpp"

namespace piae::inspection {

namespace {

using signal::DatasetInfo;
using signal::Description;
using signal::RecordSource;
using Lines = std::vector<std::string>;

constexpr double fewest_turns = 10;           // of a record; fewer show no rhythm
constexpr std::size_t sensible_stride = 100;  // the paper's own data need no less

double turns_in(double seconds, double shaft_speed_rpm) { return seconds * shaft_speed_rpm / 60; }

std::string hz_hint(double rpm) {
  return fmt::format(
      " looks like Hz, which would be {:g} rpm: all fault frequencies would then be 60 times too "
      "low",
      rpm * 60);
}

/// Once for the key of the dataset, and once for each record that has its own.
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

void add_raceways(const bearing::Geometry& g, Lines& lines) {
  const auto mismatch = raceway_mismatch(g);
  if (!mismatch) return;
  std::string what = "do not fit the pitch diameter";
  if (mismatch->too_wide) what = "look like bore and outside diameter";
  if (mismatch->too_tight) what = "look like those of the shoulders beside the raceways";
  lines.push_back(fmt::format(
      "[bearing] inner_raceway_mm = {:g} and outer_raceway_mm = {:g} {}: half their difference is "
      "{:g} mm for a ball of {:g} mm, their mean {:g} mm for a pitch of {:g} mm; without these two "
      "keys {:g} and {:g} are taken; the simulated contact and its stiffness depend on them",
      g.inner_raceway_mm, g.outer_raceway_mm, what, mismatch->gap_mm, g.ball_diameter_mm,
      mismatch->mean_mm, g.pitch_diameter_mm, g.pitch_diameter_mm - g.ball_diameter_mm,
      g.pitch_diameter_mm + g.ball_diameter_mm));
}

/// Whether the dataset's rate lets a window hold a turn, and a line be seen, at the slowest and the
/// fastest speed.
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
        "at {:g} rpm ({}): not every window then sees what happens once a turn; a lower rate of "
        "the dataset makes windows longer",
        info.sample_rate_hz, window, window_s, turns, slowest.shaft_speed_rpm, slowest.name));
  }
  if (!info.has_bearing) return;
  const FaultLines fault = fault_lines({}, info, fastest.shaft_speed_rpm);
  const double bpfi_hz = line_of(fault, signal::Defect::inner).hz;
  if (info.sample_rate_hz / 2 <= bpfi_hz) {
    lines.push_back(
        fmt::format("sample_rate_hz = {:g}: half of it does not reach BPFI, {:.4g} Hz at {:g} rpm "
                    "({}), so that "
                    "the strikes of a defect cannot be told apart; is the rate in kHz?",
                    info.sample_rate_hz, bpfi_hz, fastest.shaft_speed_rpm, fastest.name));
  }
}

std::string length_at_rate(const RecordCheck& record) {
  return fmt::format("{}: {} samples at sample_rate_hz = {:g}", place_of(record.source),
                     record.file_samples, record.source.sample_rate_hz);
}

std::string too_long(const RecordCheck& record) {
  return fmt::format(
      "{} are {:.1f} hours, too long for one run at a steady speed: is the rate in kHz? Not "
      "resampled, and not asked for lines",
      length_at_rate(record), record.length_s() / 3600);
}

std::string too_short(const RecordCheck& record) {
  return fmt::format(
      "{} are {:.3g} s, {:.2g} turns of the shaft: fewer than {:g} show no rhythm; is the rate too "
      "high?",
      length_at_rate(record), record.length_s(),
      turns_in(record.length_s(), record.source.shaft_speed_rpm), fewest_turns);
}

std::string names_of(const std::vector<const RecordCheck*>& records) {
  std::string list;
  for (const RecordCheck* record : records) {
    list += (list.empty() ? "" : ", ") + record->source.name;
  }
  return list;
}

/// A line for each of a few records. Of many, which will have one reason, a line for the first with
/// the names of the others.
void add_for_each(std::vector<const RecordCheck*> records,
                  const std::function<std::string(const RecordCheck&)>& text, Lines& lines) {
  constexpr std::size_t few = 3;
  if (records.size() > few) {
    const std::string first = text(*records.front());
    records.erase(records.begin());
    lines.push_back(fmt::format("{} (the same holds for {})", first, names_of(records)));
    return;
  }
  for (const RecordCheck* record : records) lines.push_back(text(*record));
}

void add_lengths(const std::vector<RecordCheck>& records, Lines& lines) {
  std::vector<const RecordCheck*> long_ones;
  std::vector<const RecordCheck*> short_ones;
  for (const RecordCheck& record : records) {
    if (!record.problem.empty()) continue;
    const double rpm = record.source.shaft_speed_rpm;
    if (record.length_s() > longest_record_s) long_ones.push_back(&record);
    if (turns_in(record.length_s(), rpm) < fewest_turns && !looks_like_hz(rpm)) {
      short_ones.push_back(&record);
    }
  }
  add_for_each(long_ones, too_long, lines);
  add_for_each(short_ones, too_short, lines);
}

void add_flaws(const RecordCheck& record, Lines& lines) {
  const std::string place = place_of(record.source);
  if (record.goes_one_way) {
    lines.push_back(place +
                    ": the samples only rise or only fall: a time or a counter, no "
                    "acceleration; name another variable");
    return;
  }
  const Stretches& clipped = record.clipped;
  if (clipped.count > 0) {
    lines.push_back(fmt::format(
        "{}: clipped: {} samples in {} stretches lie flat on the highest or lowest value (the "
        "longest, {} samples on {:g} from sample {}): the strikes that show a fault are cut off",
        place, clipped.samples, clipped.count, clipped.longest, clipped.value,
        clipped.longest_first));
  }
  const Stretches& held = record.held;
  if (held.count > 0) {
    lines.push_back(fmt::format(
        "{}: stands still at {:g} for {} samples ({:.3g} s) from sample {}; {} such stretch{}, "
        "{:.2g} % of the record: windows from there show no vibration",
        place, held.value, held.longest,
        static_cast<double>(held.longest) / record.source.sample_rate_hz, held.longest_first,
        held.count, held.count == 1 ? "" : "es",
        100 * static_cast<double>(held.samples) / static_cast<double>(record.file_samples)));
  }
}

void add_stride(const Description& description, const ClassCheck& found, Lines& lines) {
  if (found.stride == 0 || found.stride >= sensible_stride) return;
  const std::size_t window = signal::split_options_of(description).window;
  lines.push_back(fmt::format(
      "class {}: its recordings are so short that windows of {} samples start every {}: they "
      "overlap by {:.1f} %, and with PROTOCOL=random {:.0f} % of the test windows (A) share "
      "samples "
      "with a training window: the accuracy says little of new recordings; record longer, or take "
      "PROTOCOL=blocked",
      description.info.class_of(found.label).name, window, found.stride, 100 * found.overlap,
      100 * found.shared_with_training));
}

/// "BPFI (162.2 Hz, 25.4 dB)".
std::string shown_line(const FaultLine& line) {
  return fmt::format("{} ({:.1f} Hz, {:.1f} dB)", line_name(line.kind), line.hz, *line.db);
}

/// Why a line does not count as one.
std::string reason(const FaultLine& line) {
  if (*line.db <= line.noise_db) return fmt::format("noise alone reaches {:.1f}", line.noise_db);
  if (line.harmonics_above_noise < 2) return "only one of its harmonics does";
  return fmt::format("{:.0f} % of the places where no fault has a line do as well",
                     100 * line.share_elsewhere);
}

bool has_lines(const RecordCheck& record) {
  return record.problem.empty() && !record.goes_one_way &&
         !looks_like_hz(record.source.shaft_speed_rpm);
}

/// What is odd about the lines of a faulty record; empty where it shows its own.
std::string oddity_of_fault(const RecordCheck& record, signal::Defect defect) {
  const FaultLine& own = line_of(record.lines, defect);
  if (!own.db) return {};
  const FaultLine* first = farthest(record.lines);
  if (first == &own) return {};
  std::string line = fmt::format("{}: ", place_of(record.source));
  if (own.stands_out) {
    line += fmt::format("{} stands out farther than {}, the line of its class", shown_line(*first),
                        shown_line(own));
  } else {
    line += fmt::format("{}, the line of its class, does not stand out: {}", shown_line(own),
                        reason(own));
    if (first != nullptr) line += fmt::format("; {} does", shown_line(*first));
  }
  return line + "; label, speed or rate may be wrong, or the fault stays hidden, as some do";
}

/// The weakest of the lines that records of faulty classes show of this kind, as a measure.
std::string measure_of(const DatasetInfo& info, const std::vector<RecordCheck>& records,
                       signal::Defect kind) {
  std::optional<double> weakest;
  for (const RecordCheck& record : records) {
    if (info.class_of(record.source.label).defect != kind || !has_lines(record)) continue;
    const FaultLine& line = line_of(record.lines, kind);
    if (line.db && (!weakest || *line.db < *weakest)) weakest = line.db;
  }
  return weakest ? fmt::format(", the weakest record of such a fault {:.1f}", *weakest) : "";
}

void add_healthy_lines(const DatasetInfo& info, const std::vector<RecordCheck>& records,
                       Lines& lines) {
  for (const RecordCheck& record : records) {
    const bool healthy = info.class_of(record.source.label).defect == signal::Defect::none;
    if (!healthy || !has_lines(record)) continue;
    const FaultLine* first = farthest(record.lines);
    if (first == nullptr) continue;
    lines.push_back(fmt::format(
        "{}: healthy, but {} stands out: noise alone reaches {:.1f}{}; the label may be wrong, or "
        "the bearing not quite sound",
        place_of(record.source), shown_line(*first), first->noise_db,
        measure_of(info, records, first->kind)));
  }
}

/// Where nearly all faulty records do not show their line, they share the reason.
std::string shared_oddity(const std::vector<const RecordCheck*>& odd, std::size_t asked) {
  return fmt::format(
      "only {} of {} faulty records show the line of their class best (not {}): shaft_speed_rpm, "
      "sample_rate_hz or [bearing] may be wrong, or the labels",
      asked - odd.size(), asked, names_of(odd));
}

}  // namespace

std::string place_of(const RecordSource& source) {
  return fmt::format("{} ({}, variable {})", source.name, source.file_text(), source.variable);
}

std::vector<std::string> line_warnings(const DatasetInfo& info,
                                       const std::vector<RecordCheck>& records) {
  Lines lines;
  std::vector<const RecordCheck*> odd;
  std::size_t asked = 0;
  for (const RecordCheck& record : records) {
    const signal::Defect defect = info.class_of(record.source.label).defect;
    if (!bearing::is_struck(defect) || !has_lines(record)) continue;
    if (!line_of(record.lines, defect).db) continue;
    ++asked;
    std::string oddity = oddity_of_fault(record, defect);
    if (oddity.empty()) continue;
    odd.push_back(&record);
    lines.push_back(std::move(oddity));
  }
  constexpr std::size_t few = 2;
  if (odd.size() > few && 4 * odd.size() >= 3 * asked) return {shared_oddity(odd, asked)};
  add_healthy_lines(info, records, lines);
  return lines;
}

std::vector<std::string> warnings_of(const Description& description, const DatasetCheck& check) {
  Lines lines;
  add_speeds(description, lines);
  if (description.info.has_bearing) add_raceways(description.info.bearing, lines);
  add_rate(description, lines);
  add_lengths(check.records, lines);
  for (const RecordCheck& record : check.records) {
    if (record.problem.empty()) add_flaws(record, lines);
  }
  for (const ClassCheck& found : check.classes) add_stride(description, found, lines);
  std::ranges::move(line_warnings(description.info, check.records), std::back_inserter(lines));
  return lines;
}

}  // namespace piae::inspection
