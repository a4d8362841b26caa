#include "inspection/picture.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "inspection/svg.hpp"
#include "inspection/tables.hpp"
#include "scoring/statistics.hpp"

namespace piae::inspection {

namespace {

using signal::DatasetInfo;

constexpr double page_width = 1080;
constexpr double top = 64;  // title and legend
constexpr double row_height = 176;
constexpr double panel_top = 58;  // in a row: its title, and the names of the lines
constexpr double panel_height = 88;
constexpr double wave_left = 64;
constexpr double wave_width = 400;
constexpr double spectrum_left = 520;
constexpr double spectrum_width = 540;
constexpr double lowest_db = -10;
constexpr int marked_harmonics = 3;
constexpr double name_height = 11;

const Stroke signal_stroke{"#444444", 0.8};
const Stroke grid_stroke{"#dddddd", 0.6};

/// Outer, inner, roller: the order of FaultLines.
const std::array<Stroke, 3> line_strokes{Stroke{"#0072B2", 1, ""}, Stroke{"#D55E00", 1, "7 3"},
                                         Stroke{"#009E73", 1, "2 2"}};

/// A place on paper for numbers from `low` to `high`.
struct Axis {
  double low;
  double high;
  double from;  ///< pixels
  double to;

  [[nodiscard]] double at(double value) const {
    return from + (value - low) / (high - low) * (to - from);
  }
};

/// The lowest and highest of the values that fall on each pixel, joined: as many points as the
/// paper can show.
std::vector<Point> trace_of(const std::vector<double>& values, double step, const Axis& x,
                            const Axis& y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < values.size();) {
    const double pixel = std::floor(x.at(static_cast<double>(i) * step));
    std::size_t end = i;
    while (end < values.size() && std::floor(x.at(static_cast<double>(end) * step)) == pixel) ++end;
    const auto [low, high] = std::ranges::minmax_element(values.begin() + static_cast<long>(i),
                                                         values.begin() + static_cast<long>(end));
    const bool low_first = low < high;
    points.push_back({pixel, y.at(low_first ? *low : *high)});
    if (*low < *high) points.push_back({pixel, y.at(low_first ? *high : *low)});
    i = end;
  }
  return points;
}

bool has_lines(const FaultLines& lines) { return lines.front().hz > 0; }

void draw_legend(Svg& svg, const FaultLines& lines, const std::string& dataset) {
  svg.text({wave_left, 24}, dataset + ": recordings", Anchor::start, 16, true);
  svg.text({wave_left, 46}, fmt::format("first {:g} s about the mean", shown_s));
  svg.text({spectrum_left, 46}, "envelope spectrum, dB over its median");
  if (!has_lines(lines)) return;
  double x = spectrum_left;
  for (std::size_t i = 0; i < line_strokes.size(); ++i) {
    Stroke stroke = line_strokes.at(i);
    stroke.width = 2;
    svg.line({x, 20}, {x + 34, 20}, stroke);
    svg.text({x + 40, 24}, line_name(lines.at(i).kind));
    x += 92;
  }
  svg.text({x, 24}, "2, 3: harmonics; thick: the record's class");
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

/// In dB over the median, by bin, and nothing below the paper's edge.
std::vector<double> decibels_of(const EnvelopeSpectrum& spectrum) {
  const double floor = std::max(scoring::median(spectrum.power), spectrum.rounding);
  std::vector<double> decibels;
  for (const double power : spectrum.power) {
    decibels.push_back(
        std::max(lowest_db, 10 * std::log10(std::max(power, spectrum.rounding) / floor)));
  }
  return decibels;
}

/// Each defect's names stand on a line of their own above the panel: the higher the frequency, the
/// closer to it, so that no line crosses a name on its left.
void draw_marks(Svg& svg, const FaultLines& lines, signal::Defect own, const Axis& x, double y0) {
  if (!has_lines(lines)) return;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const FaultLine& line = lines.at(i);
    const bool is_own = line.kind == own;
    Stroke stroke = line_strokes.at(i);
    stroke.width = is_own ? 2.4 : 1;
    const auto higher =
        std::ranges::count_if(lines, [&](const FaultLine& other) { return other.hz > line.hz; });
    const double name_y = y0 - 4 - name_height * static_cast<double>(higher);
    for (int n = 1; n <= marked_harmonics; ++n) {
      const double at = x.at(n * line.hz);
      if (at > x.to) break;
      svg.line({at, name_y + 1}, {at, y0 + panel_height}, stroke);
      const std::string name = n == 1 ? line_name(line.kind) : std::to_string(n);
      svg.text({at + 3, name_y}, name, Anchor::start, 10, is_own);
    }
  }
}

/// 1, 2 or 5 times a power of ten: between four and ten steps to the end of an axis.
double tick_step(double length) {
  const double power = std::pow(10, std::floor(std::log10(length / 4)));
  const double steps = length / 4 / power;
  return power * (steps >= 5 ? 5 : steps >= 2 ? 2 : 1);
}

void draw_spectrum(Svg& svg, const RecordCheck& record, signal::Defect own, double y0) {
  const EnvelopeSpectrum& spectrum = record.envelope;
  if (spectrum.power.empty()) return;
  const std::vector<double> decibels = decibels_of(spectrum);
  const double highest_hz = static_cast<double>(spectrum.power.size()) * spectrum.bin_hz;
  // The first bins hold what the taper leaves of the mean.
  const auto first =
      std::min(decibels.size() - 1,
               static_cast<std::size_t>(std::lround(2 * spectrum.resolution_hz / spectrum.bin_hz)));
  const double highest_db =
      *std::max_element(decibels.begin() + static_cast<std::ptrdiff_t>(first), decibels.end());
  const Axis x{0, highest_hz, spectrum_left, spectrum_left + spectrum_width};
  const Axis y{lowest_db, std::max(20.0, highest_db + 2), y0 + panel_height, y0};
  for (int db = 0; db <= y.high; db += 10) {
    svg.line({x.from, y.at(db)}, {x.to, y.at(db)}, grid_stroke);
    if (db % 20 == 0) {
      svg.text({x.from - 5, y.at(db) + 4}, std::to_string(db), Anchor::end);
    }
  }
  const double step_hz = tick_step(highest_hz);
  for (int tick = 0; tick * step_hz < highest_hz; ++tick) {
    const double hz = tick * step_hz;
    svg.text({x.at(hz), y0 + panel_height + 14}, fmt::format("{:g}", hz), Anchor::middle);
  }
  svg.text({x.to, y0 + panel_height + 14}, "Hz", Anchor::end);
  draw_marks(svg, record.lines, own, x, y0);
  std::vector<double> shown = decibels;
  std::fill(shown.begin(), shown.begin() + static_cast<std::ptrdiff_t>(first), lowest_db);
  svg.polyline(trace_of(shown, spectrum.bin_hz, x, y), signal_stroke);
  svg.frame({x.from, y0}, spectrum_width, panel_height);
}

std::string row_title(const RecordCheck& record, signal::Defect own) {
  std::string title = fmt::format("{} ({})", record.source.name, record.source.file);
  if (own == signal::Defect::none) return title + ", healthy";
  if (!bearing::is_struck(own)) return title + ", no fault of the bearing";
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
    draw_spectrum(svg, *record, own, y + panel_top);
    y += row_height;
  }
  return svg.str();
}

}  // namespace piae::inspection
