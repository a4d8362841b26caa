#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "inspection/common_factor.hpp"
#include "inspection/plausibility.hpp"
#include "inspection/warning_text.hpp"
#include "inspection/warnings.hpp"

namespace piae::inspection {

namespace {

using signal::DatasetInfo;
using Lines = std::vector<std::string>;

/// Returns a text such as "BPFI (162.2 Hz, 25.4 dB)".
std::string shown_line(const FaultLine& line) {
  return fmt::format("{} ({:.1f} Hz, {:.1f} dB)", line_name(line.fault_type), line.hz, *line.db);
}

/// Returns why a line does not stand out.
std::string reason(const FaultLine& line) {
  if (*line.db <= line.noise_db) return fmt::format("noise alone reaches {:.1f} dB", line.noise_db);
  if (line.harmonics_above_noise < 2) return "only one of its harmonics does";
  return fmt::format("{:.0f} % of the frequencies without a fault line stand out as far",
                     100 * line.share_elsewhere);
}

/// True if the shaft certainly turns so much faster or slower that lines are not at their places.
bool turns_otherwise(const RecordCheck& record) {
  constexpr double percent = 100 * spectra::line_tolerance;
  const double given_rpm = record.source.shaft_speed_rpm;
  return record.shaft && record.shaft->is_certain() && !record.shaft->is_within(percent, given_rpm);
}

bool has_lines(const RecordCheck& record) {
  return record.problem.empty() && !record.goes_one_way && !record.few_values &&
         !turns_otherwise(record) && !looks_like_hz(record.source.shaft_speed_rpm) &&
         record.turns() >= fewest_turns;
}

/// Returns what is odd about the lines of a faulty record. Empty if its own line stands out
/// farthest, or was not measured.
std::string oddity_of_fault(const RecordCheck& record, signal::Defect defect) {
  const FaultLine& own = line_of(record.lines, defect);
  if (!own.db) return {};
  const FaultLine* first = farthest(record.lines);
  if (first == &own) return {};
  std::string line = fmt::format("{}: ", place_of(record.source));
  if (own.stands_out) {
    line += fmt::format("{} stands out more than {}, the line of its class", shown_line(*first),
                        shown_line(own));
  } else {
    line += fmt::format("{}, the line of its class, does not stand out: {}", shown_line(own),
                        reason(own));
    if (first != nullptr) line += fmt::format("; {} does", shown_line(*first));
  }
  return line + "; the label, speed or rate may be wrong, or the fault is one that hides its line";
}

/// Returns a clause with the weakest such line of faulty records, for comparison; empty without
/// one.
std::string measure_of(const DatasetInfo& info, const std::vector<RecordCheck>& records,
                       signal::Defect fault_type) {
  std::optional<double> weakest;
  for (const RecordCheck& record : records) {
    if (info.class_of(record.source.label).defect != fault_type || !has_lines(record)) continue;
    const FaultLine& line = line_of(record.lines, fault_type);
    if (line.db && (!weakest || *line.db < *weakest)) weakest = line.db;
  }
  return weakest ? fmt::format(", the weakest record of such a fault {:.1f} dB", *weakest) : "";
}

void add_healthy_lines(const DatasetInfo& info, const std::vector<RecordCheck>& records,
                       Lines& lines) {
  for (const RecordCheck& record : records) {
    const bool healthy = info.class_of(record.source.label).defect == signal::Defect::none;
    if (!healthy || !has_lines(record)) continue;
    const FaultLine* first = farthest(record.lines);
    if (first == nullptr) continue;
    lines.push_back(
        fmt::format("{}: healthy, but {} stands out: noise alone reaches {:.1f} dB{}; the label "
                    "may be wrong, or the bearing may be slightly damaged",
                    place_of(record.source), shown_line(*first), first->noise_db,
                    measure_of(info, records, first->fault_type)));
  }
}

/// Reports once that most faulty records miss their line, because they share the cause.
std::string shared_oddity(const std::vector<const RecordCheck*>& odd, std::size_t candidates) {
  return fmt::format(
      "only {} of {} faulty records show the line of their class most clearly (not {}); "
      "shaft_speed_rpm, sample_rate_hz, [bearing] or the labels may be wrong",
      candidates - odd.size(), candidates, names_of(odd));
}

/// Reports lines that are off by a common factor: the speed or the rate is wrong by it.
std::string shared_factor(const CommonFactor& common, std::size_t candidates) {
  const signal::RecordSource& first = common.records.front()->source;
  return fmt::format(
      "{} of {} faulty records show the line of their class at {:.3g} times its frequency ({}); "
      "for {}, try shaft_speed_rpm = {:.4g} instead of {:g}, or sample_rate_hz = {:.4g} instead of "
      "{:g}",
      common.records.size(), candidates, common.factor, names_of(common.records), first.name,
      first.shaft_speed_rpm * common.factor, first.shaft_speed_rpm,
      first.sample_rate_hz / common.factor, first.sample_rate_hz);
}

}  // namespace

std::vector<std::string> line_warnings(const DatasetInfo& info,
                                       const std::vector<RecordCheck>& records) {
  Lines lines;
  std::vector<const RecordCheck*> candidates;
  std::vector<const RecordCheck*> odd;
  for (const RecordCheck& record : records) {
    const signal::Defect defect = info.class_of(record.source.label).defect;
    if (!bearing::causes_impacts(defect) || !has_lines(record)) continue;
    if (!line_of(record.lines, defect).db) continue;
    candidates.push_back(&record);
    std::string oddity = oddity_of_fault(record, defect);
    if (oddity.empty()) continue;
    odd.push_back(&record);
    lines.push_back(std::move(oddity));
  }
  if (const auto common = common_factor(info, candidates)) {
    return {shared_factor(*common, candidates.size())};
  }
  constexpr std::size_t few = 2;
  if (odd.size() > few && 4 * odd.size() >= 3 * candidates.size()) {
    return {shared_oddity(odd, candidates.size())};
  }
  add_healthy_lines(info, records, lines);
  return lines;
}

}  // namespace piae::inspection
