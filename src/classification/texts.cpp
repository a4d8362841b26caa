#include "classification/texts.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "bearing/defect.hpp"
#include "spectra/shown_speed.hpp"
#include "text/csv.hpp"
#include "text/table.hpp"

namespace piae::classification {

namespace {

using signal::DatasetInfo;

constexpr std::size_t terminal_width = 80;
constexpr std::size_t longest_name = 22;

/// Longest names in a table.
struct Longest {
  std::size_t record = longest_name;
  std::size_t class_name = longest_name;
};

/// Shortens names by one character; false if they cannot be shorter. Records stay apart as long as
/// possible.
bool shorten(Longest& longest) {
  constexpr std::size_t distinct_record = 12;
  constexpr std::size_t distinct_class = 6;
  constexpr std::size_t shortest = 4;
  std::size_t* which = nullptr;
  if (longest.record > distinct_record) {
    which = &longest.record;
  } else if (longest.class_name > distinct_class) {
    which = &longest.class_name;
  } else {
    which = longest.record > shortest ? &longest.record : &longest.class_name;
  }
  if (*which == shortest) return false;
  --*which;
  return true;
}

bool begins_character(char byte) { return (byte & 0xC0) != 0x80; }

/// Cuts the beginning off long names, because names that start alike differ at the end.
std::string shortened(const std::string& name, std::size_t longest) {
  auto characters = static_cast<std::size_t>(std::ranges::count_if(name, begins_character));
  if (characters <= longest) return name;
  std::size_t cut = 0;
  while (characters > longest - 2) {
    do ++cut;
    while (cut < name.size() && !begins_character(name[cut]));
    --characters;
  }
  return ".." + name.substr(cut);
}

std::size_t widest_line_of(const std::string& text) {
  std::size_t widest = 0;
  std::size_t width = 0;
  for (const char byte : text) {
    if (byte == '\n') {
      width = 0;
    } else if (begins_character(byte)) {
      widest = std::max(widest, ++width);
    }
  }
  return widest;
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

/// Returns text such as "BPFI +12.3 dB".
std::string words_of(const inspection::FaultLine& line) {
  return fmt::format("{} {:+.1f} dB", inspection::line_name(line.fault_type), line.db.value_or(0));
}

/// Returns the table with names of limited length. Its column of unknown windows is left out if
/// unknown faults are not detected.
std::string table_with_names(const std::vector<Verdict>& verdicts, const DatasetInfo& info,
                             const Longest& longest) {
  const bool has_true_classes = std::ranges::any_of(
      verdicts, [](const Verdict& verdict) { return !verdict.recording.true_class.empty(); });
  std::vector<std::string> header{"recording"};
  if (has_true_classes) header.emplace_back("said");
  header.insert(header.end(), {"named", "evidence", "sure", "agree"});
  const bool can_refuse = std::ranges::any_of(verdicts, &Verdict::can_refuse);
  if (can_refuse) header.emplace_back("unknown");
  header.emplace_back("windows");
  text::Table table(header, has_true_classes ? 4 : 3);
  for (const Verdict& verdict : verdicts) {
    std::vector<std::string> row{shortened(verdict.recording.name, longest.record)};
    if (has_true_classes) {
      row.push_back(shortened(verdict.recording.true_class, longest.class_name));
    }
    row.push_back(verdict.unknown
                      ? "unknown"
                      : shortened(info.class_of(verdict.label).name, longest.class_name));
    row.push_back(evidence_of(verdict, info));
    row.push_back(verdict.unknown ? "-" : percent(verdict.probability));
    row.push_back(verdict.unknown ? "-" : percent(verdict.share));
    if (can_refuse) row.push_back(verdict.can_refuse ? percent(verdict.share_unknown) : "-");
    row.push_back(std::to_string(verdict.start_s.size()));
    table.row(row);
  }
  return table.plain();
}

}  // namespace

std::string evidence_of(const Verdict& verdict, const DatasetInfo& info) {
  if (!info.has_bearing) return "bearing unknown";
  const signal::Defect named = info.class_of(verdict.label).defect;
  const inspection::FaultLine* const farthest = inspection::farthest(verdict.lines);
  if (verdict.unknown || !bearing::causes_impacts(named)) {
    return farthest == nullptr ? "no fault line" : words_of(*farthest);
  }
  const inspection::FaultLine& own = inspection::line_of(verdict.lines, named);
  if (!own.db) return "too short for lines";
  if (own.stands_out) return words_of(own);
  if (farthest == nullptr) return words_of(own) + ", faint";
  return fmt::format("{}, not {}", words_of(*farthest), inspection::line_name(own.fault_type));
}

std::string table_of(const std::vector<Verdict>& verdicts, const DatasetInfo& info) {
  Longest longest;
  std::string table = table_with_names(verdicts, info, longest);
  while (widest_line_of(table) > terminal_width && shorten(longest)) {
    table = table_with_names(verdicts, info, longest);
  }
  return table;
}

std::string speeds_of(const std::vector<Verdict>& verdicts) {
  std::string lines;
  for (const Verdict& verdict : verdicts) {
    const Recording& recording = verdict.recording;
    const std::string other = spectra::other_speed(recording.shaft, recording.given_speed_rpm);
    if (other.empty()) continue;
    const bool is_used = recording.shaft_speed_rpm != recording.given_speed_rpm;
    lines += fmt::format(
        "{}: {} {:g} rpm; {}\n", recording.name, other, recording.given_speed_rpm,
        is_used ? "this speed was used" : "--speed-search-percent takes the speed from the signal");
  }
  return lines;
}

std::string origin_of(const diagnosis::KeptClassifier& kept,
                      const std::optional<diagnosis::Trust>& trust) {
  const diagnosis::ClassifierOrigin& origin = kept.origin();
  const std::string unknown =
      kept.novelty()
          ? ""
          : "unknown faults are not detected: no fault is known in the tested condition\n";
  if (!trust) {
    return fmt::format(
        "by {}, taught on simulated machines, against {} healthy windows of {}\n"
        "probabilities are not calibrated, and the accuracy on this machine is not known\n{}",
        kept.classifier().name, origin.training_windows, kept.info().name, unknown);
  }
  return fmt::format(
      "by {} of {}, trained on {} windows ({} {}, seed {})\n"
      "accuracy on windows outside the training set: {:.1f} %\nprobabilities {}\n{}",
      kept.classifier().name, kept.info().name, origin.training_windows, origin.method,
      origin.ratio, origin.seed, 100 * trust->accuracy,
      kept.calibration().windows > 0
          ? fmt::format("were off by {:.1f} points on average", 100 * trust->calibration_error)
          : "are not calibrated: there are too few windows to leave some out",
      unknown);
}

std::string csv_of(const std::vector<Verdict>& verdicts, const DatasetInfo& info) {
  std::vector<std::string> header{"recording",   "start_s",     "class",
                                  "probability", "strangeness", "unknown"};
  for (const signal::ClassInfo& each : info.classes) header.push_back("p_" + each.name);
  std::string csv = text::csv_line(header);
  const std::size_t classes = info.classes.size();
  for (const Verdict& verdict : verdicts) {
    for (std::size_t i = 0; i < verdict.start_s.size(); ++i) {
      const Label named = verdict.predictions.labels[i];
      const float* const probabilities = verdict.predictions.probabilities.data() + i * classes;
      std::vector<std::string> fields{verdict.recording.name,
                                      fmt::format("{:.6f}", verdict.start_s[i]),
                                      info.class_of(named).name,
                                      fmt::format("{:.4f}", probabilities[index_of(named)]),
                                      fmt::format("{:.4f}", verdict.predictions.novelty[i]),
                                      verdict.is_unknown(i) ? "1" : "0"};
      for (std::size_t k = 0; k < classes; ++k) {
        fields.push_back(fmt::format("{:.4f}", probabilities[k]));
      }
      csv += text::csv_line(fields);
    }
  }
  return csv;
}

}  // namespace piae::classification
