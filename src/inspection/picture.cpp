#include "inspection/picture.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "inspection/drawing.hpp"
#include "inspection/spectrum_panel.hpp"
#include "inspection/svg.hpp"
#include "inspection/tables.hpp"

namespace piae::inspection {

namespace {

using signal::DatasetInfo;

constexpr double page_width = 1080;
constexpr double top = 64;  // title and legend
constexpr double row_height = 176;
constexpr double panel_top = 58;  // in a row: title and line names
constexpr double panel_height = 88;
constexpr double wave_left = 64;
constexpr double wave_width = 400;
constexpr double spectrum_left = 520;
constexpr double spectrum_width = 540;

void draw_legend(Svg& svg, const FaultLines& lines, const std::string& dataset) {
  svg.text({wave_left, 24}, dataset + ": recordings", Anchor::start, 16, true);
  svg.text({wave_left, 46}, fmt::format("first {:g} s, mean removed", shown_s));
  svg.text({spectrum_left, 46}, "envelope spectrum, dB over its median");
  draw_line_legend(svg, lines, {spectrum_left, 24}, "the record's class");
}

void draw_wave(Svg& svg, const RecordCheck& record, const DatasetInfo& info, double y0) {
  std::vector<double> values = record.beginning;
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  double peak = 0;
  for (double& value : values) {
    value -= mean;
    peak = std::max(peak, std::abs(value));
  }
  if (peak == 0) peak = 1;
  const Axis x{0, shown_s, wave_left, wave_left + wave_width};
  const Axis y{-1.05 * peak, 1.05 * peak, y0 + panel_height, y0};
  for (const double value : {-peak, 0.0, peak}) {
    svg.line({x.from, y.at(value)}, {x.to, y.at(value)}, grid_stroke);
    svg.text({x.from - 5, y.at(value) + 4}, fmt::format("{:.2g}", value), Anchor::end);
  }
  for (int tick = 0; tick <= 4; ++tick) {
    const double seconds = tick * shown_s / 4;
    svg.text({x.at(seconds), y0 + panel_height + 14}, fmt::format("{:g}", seconds), Anchor::middle);
  }
  svg.text({x.from - 5, y0 - 6}, unit_name(info.unit_m_per_s2), Anchor::end);
  svg.text({x.to + 12, y0 + panel_height + 14}, "s");
  svg.polyline(trace_of(values, 1 / info.sample_rate_hz, x, y), signal_stroke);
  svg.frame({x.from, y0}, wave_width, panel_height);
}

std::string row_title(const RecordCheck& record, signal::Defect own) {
  std::string title = fmt::format("{} ({})", record.source.name, record.source.file_text());
  if (own == signal::Defect::none) return title + ", healthy";
  if (!bearing::causes_impacts(own)) return title + ", no fault of the bearing";
  const FaultLine& line = line_of(record.lines, own);
  title += fmt::format(", {} {:.1f} Hz", line_name(own), line.hz);
  return line.db ? title + fmt::format(": {:.1f} dB", *line.db) : title;
}

}  // namespace

std::string picture_of(const DatasetInfo& info, const DatasetCheck& check) {
  std::vector<const RecordCheck*> shown;
  for (const RecordCheck& record : check.records) {
    if (!record.beginning.empty()) shown.push_back(&record);
  }
  Svg svg(page_width, top + row_height * static_cast<double>(shown.size()) + 8,
          info.name + ": waveforms and envelope spectra of the recordings");
  if (!shown.empty()) draw_legend(svg, shown.front()->lines, info.name);
  double y = top;
  for (const RecordCheck* record : shown) {
    const signal::Defect own = info.class_of(record->source.label).defect;
    svg.text({wave_left, y + 16}, row_title(*record, own), Anchor::start, 12, true);
    draw_wave(svg, *record, info, y + panel_top);
    draw_envelope_spectrum(svg, record->envelope, record->lines, own,
                           {.left = spectrum_left,
                            .top = y + panel_top,
                            .width = spectrum_width,
                            .height = panel_height});
    y += row_height;
  }
  return svg.str();
}

}  // namespace piae::inspection
