#include "inspection/tables.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "signal/described_split.hpp"
#include "text/table.hpp"

namespace piae::inspection {

namespace {

using signal::DatasetInfo;
using Row = std::vector<std::string>;

constexpr std::size_t widest_line = 100;
constexpr std::size_t widest_name = 14;
constexpr std::size_t widest_class = 24;
constexpr std::size_t widest_file = 48;
constexpr std::size_t narrowest_file = 8;

const char* const lines_note =
    "measured: speed of the shaft in the signal, within 10 % of the given one; -: it hardly shows\n"
    "dB: mean height of the line and its 2nd and 3rd harmonics above the floor of the envelope "
    "spectrum\n"
    "*: the line of the record's class; noise alone exceeds 'noise dB' in 1 of 1000 records\n\n";

const char* const unknown_lines_note =
    "The bearing is not described. rpm: as the signal shows, if it does; else as given\n"
    "order: fault line over the shaft's speed; dB: its mean height above the healthy record\n"
    "bearings: of bearings.csv, within 1 %; high: 18 dB, clear side bands, certain speed, known "
    "bearing\n\n";

/// Returns the end of a text, because names and files differ more at their end than at their start.
std::string shortened(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text;
  std::size_t first = text.size() - width + 1;
  const auto inside_a_character = [&] { return (text[first] & 0xC0) == 0x80; };
  while (first < text.size() && inside_a_character()) ++first;
  return "…" + text.substr(first);
}

bool fits(const std::string& table) {
  std::size_t width = 0;
  return std::ranges::all_of(table, [&](char c) {
    width = c == '\n' ? 0 : width + ((c & 0xC0) != 0x80 ? 1 : 0);
    return width <= widest_line;
  });
}

/// Returns the number of windows without overlap that fit, each within one file.
std::size_t windows_in(const RecordCheck& record, std::size_t window) {
  std::size_t windows = 0;
  for (const std::size_t length : record.pieces) windows += length / window;
  return windows;
}

/// Returns the names of the files, shortened to this width, and their number.
std::string files_of(const RecordCheck& record, std::size_t width) {
  const std::size_t count = record.files.size();
  return shortened(record.source.file_text(), width) +
         (count > 1 ? fmt::format(" ({} files)", count) : "");
}

text::Table recordings_table(const signal::Description& description, const DatasetCheck& check,
                             std::size_t file_width) {
  const DatasetInfo& info = description.info;
  const std::size_t window = signal::split_options_of(description).window;
  text::Table table({"record", "file", "file Hz", "Hz", "s", "windows",
                     "RMS " + unit_name(info.unit_m_per_s2), "kurtosis", "crest"},
                    2);
  for (const RecordCheck& record : check.records) {
    const signal::RecordSource& source = record.source;
    Row row{shortened(source.name, widest_name), files_of(record, file_width)};
    if (!record.problem.empty()) {
      row.emplace_back("no data");
    } else {
      row.insert(
          row.end(),
          {fmt::format("{:.6g}", source.sample_rate_hz), fmt::format("{:.6g}", info.sample_rate_hz),
           fmt::format("{:.3f}", record.length_s()), std::to_string(windows_in(record, window))});
    }
    if (record.level) {
      row.insert(row.end(), {fmt::format("{:.4g}", record.level->rms),
                             fmt::format("{:.2f}", record.level->kurtosis),
                             fmt::format("{:.2f}", record.level->crest_factor)});
    }
    table.row(row);
  }
  return table;
}

/// Returns the table with file names as long as the width allows.
std::string recordings_text(const signal::Description& description, const DatasetCheck& check) {
  for (std::size_t width = widest_file;; --width) {
    std::string text = recordings_table(description, check, width).plain();
    if (fits(text) || width == narrowest_file) return text;
  }
}

/// Returns the table of fault lines; empty without a readable record.
std::string lines_table(const DatasetInfo& info, const DatasetCheck& check) {
  text::Table table(
      {"record", "rpm", "measured", "BPFO Hz", "dB", "BPFI Hz", "dB", "2BSF Hz", "dB", "noise dB"},
      1);
  for (const RecordCheck& record : check.records) {
    if (!record.problem.empty()) continue;
    const signal::Defect own = info.class_of(record.source.label).defect;
    Row row{shortened(record.source.name, widest_name),
            fmt::format("{:.6g}", record.source.shaft_speed_rpm),
            record.shaft && record.shaft->is_certain() ? fmt::format("{:.0f}", record.shaft->rpm)
                                                       : "-"};
    for (const FaultLine& line : record.lines) {
      row.push_back(fmt::format("{:.2f}", line.hz));
      const std::string mark = line.fault_type == own ? "*" : "";
      row.push_back(mark + (line.db ? fmt::format("{:.1f}", *line.db) : "-"));
    }
    const double noise_db = std::ranges::max(record.lines, {}, &FaultLine::noise_db).noise_db;
    row.push_back(noise_db > 0 ? fmt::format("{:.1f}", noise_db) : "-");
    table.row(row);
  }
  return table.rows().empty() ? "" : table.plain() + lines_note;
}

std::string likeness_text(Likeness likeness) {
  switch (likeness) {
    case Likeness::outer:
      return "outer race";
    case Likeness::inner:
      return "inner race";
    case Likeness::outer_or_inner:
      return "outer or inner";
    case Likeness::ball:
      return "ball";
    case Likeness::cage:
      return "cage";
    case Likeness::nothing:
      break;
  }
  return "none can be named";
}

std::string confidence_text(const UnknownLine& line) {
  if (line.likeness == Likeness::nothing) return "-";
  return line.is_certain ? "high" : "fair";
}

/// Returns as many names as fit, and the number of the others.
std::string some_names_of(const std::vector<std::string>& bearings) {
  constexpr std::size_t widest_names = 24;
  std::string text;
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    if (i > 0 && text.size() + bearings[i].size() > widest_names) {
      return text + fmt::format(" +{}", bearings.size() - i);
    }
    text += (i == 0 ? "" : ", ") + bearings[i];
  }
  return text.empty() ? "-" : text;
}

/// Returns the table of unknown lines; empty if no record has one.
std::string unknown_lines_table(const DatasetCheck& check) {
  text::Table table(
      {"record", "looks like", "confidence", "bearings with this line", "rpm", "order", "dB"}, 4);
  for (const RecordCheck& record : check.records) {
    if (!record.unknown_line) continue;
    const UnknownLine& line = *record.unknown_line;
    table.row(Row{shortened(record.source.name, widest_name), likeness_text(line.likeness),
                  confidence_text(line), some_names_of(line.bearings),
                  fmt::format("{:.0f}", record.shown_speed_rpm()),
                  line.order > 0 ? fmt::format("{:.3f}", line.order) : "-",
                  fmt::format("{:.1f}", line.db)});
  }
  return table.rows().empty() ? "" : table.plain() + unknown_lines_note;
}

/// Returns the size of a defect, or "-" if unknown.
std::string size_of(const signal::ClassInfo& c) {
  const bool is_unknown = c.defect != signal::Defect::none && c.defect_size_mm == 0;
  return is_unknown ? "-" : fmt::format("{:g}", c.defect_size_mm);
}

std::string classes_table(const DatasetInfo& info, const DatasetCheck& check) {
  text::Table table({"class", "defect", "mm", "records", "stride", "overlap %", "A meets B, C %"},
                    2);
  for (const ClassCheck& found : check.classes) {
    const signal::ClassInfo& described = info.class_of(found.label);
    Row row{shortened(described.name, widest_class), signal::to_string(described.defect),
            size_of(described), std::to_string(found.records), "-"};
    if (found.stride > 0) {
      row.back() = std::to_string(found.stride);
      row.push_back(fmt::format("{:.1f}", 100 * found.overlap));
      row.push_back(fmt::format("{:.0f}", 100 * found.shared_with_training));
    }
    table.row(row);
  }
  return table.plain();
}

const char* const classes_note =
    "A meets B, C: test windows that share samples with a training window if PROTOCOL=random\n";

}  // namespace

std::string unit_name(double unit_m_per_s2) {
  constexpr double g = 9.80665;
  const auto is = [&](double other) { return std::abs(unit_m_per_s2 / other - 1) < 1e-3; };
  // A unit of 1 means m/s² or an unknown unit (pipeline/datasets/README.md).
  if (is(g)) return "g";
  if (is(g / 1000)) return "mg";
  return "units";
}

std::string tables_of(const signal::Description& description, const DatasetCheck& check) {
  const DatasetInfo& info = description.info;
  return fmt::format(
      "{}: all records at {:g} Hz, unit_m_per_s2 = {:g}, windows of {} samples\n\n{}\n{}{}{}",
      info.name, info.sample_rate_hz, info.unit_m_per_s2,
      signal::split_options_of(description).window, recordings_text(description, check),
      info.has_bearing ? lines_table(info, check) : unknown_lines_table(check),
      classes_table(info, check), classes_note);
}

}  // namespace piae::inspection
