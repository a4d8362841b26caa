#include "classification/page_charts.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "inspection/drawing.hpp"
#include "inspection/spectrum_panel.hpp"
#include "inspection/svg.hpp"
#include "spectra/floors.hpp"
#include "spectra/lengths.hpp"
#include "spectra/power.hpp"

namespace piae::classification {

namespace {

using inspection::Anchor;
using inspection::Axis;
using inspection::Panel;
using inspection::Svg;

constexpr double chart_width = 760;
constexpr double below_chart = 34;  // numbers of both axes
constexpr Panel wave_panel{.left = 56, .top = 8, .width = 696, .height = 170};
constexpr Panel lines_panel{.left = 56, .top = 40, .width = 696, .height = 280};  // below names

constexpr double turns_of_a_segment = 32;
constexpr double largest_segment = 32768;
constexpr double part_of_recording = 0.4;
constexpr double fewest_samples = 10;
constexpr Eigen::Index most_averages = 100;  // longer recordings are sampled at intervals

Svg empty_chart(const Panel& panel, const std::string& title) {
  return {chart_width, panel.top + panel.height + below_chart, title};
}

/// Draws numbers below a panel, in the row 0 or 1. `from` and `to` are those of the panel.
void draw_numbers(Svg& svg, double high, const std::string& unit, int row, const Panel& panel) {
  constexpr double row_height = 14;
  constexpr double unit_width = 46;
  const Axis x{0, high, panel.left, panel.left + panel.width};
  const double y = panel.top + panel.height + row_height * (row + 1);
  const double step = inspection::tick_step(high);
  for (int tick = 0; x.at(tick * step) < x.to - unit_width; ++tick) {
    svg.text({x.at(tick * step), y}, fmt::format("{:g}", tick * step), Anchor::middle);
  }
  svg.text({x.to, y}, unit, Anchor::end);
}

/// Draws numbers and lines to the left of a panel.
void draw_levels(Svg& svg, const Axis& y, const Panel& panel) {
  const double step = inspection::tick_step(y.high - y.low);
  for (double tick = std::ceil(y.low / step); tick * step <= y.high; ++tick) {
    const double at = y.at(tick * step);
    svg.line({panel.left, at}, {panel.left + panel.width, at}, inspection::grid_stroke);
    svg.text({panel.left - 5, at + 4}, fmt::format("{:g}", tick * step), Anchor::end);
  }
}

/// Returns JSON's text of the members that all charts have.
std::string members_of(const Panel& panel, const Axis& y, double step) {
  return fmt::format(
      "\"left\":{:g},\"top\":{:g},\"width\":{:g},\"height\":{:g},\"lowest\":{:.4g},"
      "\"highest\":{:.4g},\"step\":{:.9g}",
      panel.left, panel.top, panel.width, panel.height, y.low, y.high, step);
}

/// Returns JSON's text of tenths of a decibel.
std::string tenths_of(const std::vector<double>& decibels) {
  std::string text;
  for (const double db : decibels) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", std::lround(10 * db));
  }
  return "[" + text + "]";
}

/// The lowest and highest sample of each column of pixels.
struct Columns {
  std::vector<double> low;
  std::vector<double> high;
};

Columns columns_of(const std::vector<double>& signal, std::size_t most) {
  const std::size_t count = std::min(most, signal.size());
  Columns columns;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [low, high] = std::ranges::minmax(std::span(signal).subspan(
        i * signal.size() / count, (i + 1) * signal.size() / count - i * signal.size() / count));
    columns.low.push_back(low);
    columns.high.push_back(high);
  }
  return columns;
}

std::string samples_text(const std::vector<double>& samples) {
  std::string text;
  for (const double sample : samples) {
    text += fmt::format("{}{:.3g}", text.empty() ? "" : ",", sample);
  }
  return "[" + text + "]";
}

/// Returns segments of a signal that overlap by half, or fewer at equal intervals.
spectra::Windows half_overlapping(std::span<const double> signal, std::size_t length) {
  const std::size_t half = std::max<std::size_t>(1, length / 2);
  const auto count = std::min<Eigen::Index>(
      most_averages, static_cast<Eigen::Index>((signal.size() - length) / half + 1));
  const std::size_t step =
      count > 1 ? (signal.size() - length) / static_cast<std::size_t>(count - 1) : 0;
  spectra::Windows segments(count, static_cast<Eigen::Index>(length));
  for (Eigen::Index i = 0; i < count; ++i) {
    segments.row(i) = Eigen::Map<const Eigen::RowVectorXd>(
        signal.data() + static_cast<std::size_t>(i) * step, segments.cols());
  }
  return segments;
}

/// Returns whole tens of decibels that hold the highest value, the median, and 20 dB below it.
Axis decibel_axis(const std::vector<double>& decibels, const Panel& panel) {
  const double low = std::floor((spectra::median(decibels) - 20) / 10) * 10;
  const double high = std::ceil((std::ranges::max(decibels) + 2) / 10) * 10;
  return {low, std::max(high, low + 40), panel.top + panel.height, panel.top};
}

}  // namespace

AmplitudeSpectrum amplitude_spectrum(std::span<const double> signal, double rate_hz,
                                     double shaft_hz) {
  AmplitudeSpectrum spectrum;
  const double samples = std::min({turns_of_a_segment * rate_hz / shaft_hz, largest_segment,
                                   part_of_recording * static_cast<double>(signal.size())});
  if (samples < fewest_samples) return spectrum;
  const std::size_t length = spectra::fast_length(static_cast<std::size_t>(samples));
  const spectra::Windows segments = half_overlapping(signal, length);
  spectrum.bin_hz = rate_hz / static_cast<double>(length);
  spectrum.segments = static_cast<std::size_t>(segments.rows());
  // A tone of amplitude a at a bin has the transform a / 2 times the sum over the taper, which is
  // half its length, and the mean square a^2 / 2.
  const double mean_square = 8 / std::pow(static_cast<double>(length), 2);
  for (const double power : spectra::mean_power_spectrum(segments)) {
    spectrum.db.push_back(
        10 * std::log10(std::max(mean_square * power, std::numeric_limits<double>::min())));
  }
  return spectrum;
}

Chart waveform_chart(const Verdict& verdict, const signal::DatasetInfo& info) {
  const std::vector<double>& signal = verdict.recording.signal;
  const Panel& panel = wave_panel;
  const double length_s = static_cast<double>(signal.size()) / info.sample_rate_hz;
  const auto [lowest, highest] = std::ranges::minmax(signal);
  const double margin = 0.05 * std::max(highest - lowest, 1e-12 * std::abs(highest));
  const Axis x{0, length_s, panel.left, panel.left + panel.width};
  const Axis y{lowest - margin, highest + margin, panel.top + panel.height, panel.top};
  Svg svg = empty_chart(panel, "waveform");
  draw_levels(svg, y, panel);
  draw_numbers(svg, length_s, "s", 0, panel);
  draw_numbers(svg, length_s * verdict.recording.shaft_speed_rpm / 60, "turns", 1, panel);
  svg.polyline(trace_of(signal, 1 / info.sample_rate_hz, x, y), inspection::signal_stroke);
  svg.frame({panel.left, panel.top}, panel.width, panel.height);
  const Columns columns = columns_of(signal, static_cast<std::size_t>(panel.width));
  return {.drawing = svg.element(),
          .numbers =
              fmt::format("{{{},\"low\":{},\"high\":{}}}",
                          members_of(panel, y, length_s / static_cast<double>(columns.low.size())),
                          samples_text(columns.low), samples_text(columns.high))};
}

Chart amplitude_chart(const Verdict& verdict, const signal::DatasetInfo& info, signal::Defect own) {
  const double shaft_hz = verdict.recording.shaft_speed_rpm / 60;
  const AmplitudeSpectrum spectrum =
      amplitude_spectrum(verdict.recording.signal, info.sample_rate_hz, shaft_hz);
  const Panel& panel = lines_panel;
  Svg svg = empty_chart(panel, "amplitude spectrum");
  if (spectrum.db.empty()) return {.drawing = svg.element(), .numbers = "null"};
  const double highest_hz = static_cast<double>(spectrum.db.size()) * spectrum.bin_hz;
  const Axis x{0, highest_hz, panel.left, panel.left + panel.width};
  const Axis y = decibel_axis(spectrum.db, panel);
  std::vector<double> shown = spectrum.db;
  for (double& db : shown) db = std::max(db, y.low);
  draw_levels(svg, y, panel);
  draw_numbers(svg, highest_hz, "Hz", 0, panel);
  draw_numbers(svg, highest_hz / shaft_hz, "orders", 1, panel);
  draw_fault_lines(svg, verdict.lines, own, 1, x, panel);
  svg.polyline(trace_of(shown, spectrum.bin_hz, x, y), inspection::signal_stroke);
  svg.frame({panel.left, panel.top}, panel.width, panel.height);
  return {.drawing = svg.element(),
          .numbers = fmt::format("{{{},\"tenths\":{}}}", members_of(panel, y, spectrum.bin_hz),
                                 tenths_of(spectrum.db))};
}

Chart envelope_chart(const Verdict& verdict, signal::Defect own) {
  const inspection::EnvelopeSpectrum& spectrum = verdict.envelope;
  const Panel& panel = lines_panel;
  Svg svg = empty_chart(panel, "envelope spectrum");
  if (spectrum.power.empty()) return {.drawing = svg.element(), .numbers = "null"};
  const Axis y = draw_envelope_spectrum(svg, spectrum, verdict.lines, own, panel);
  const double highest_hz = static_cast<double>(spectrum.power.size()) * spectrum.bin_hz;
  draw_numbers(svg, highest_hz * 60 / verdict.recording.shaft_speed_rpm, "orders", 1, panel);
  return {.drawing = svg.element(),
          .numbers = fmt::format("{{{},\"tenths\":{}}}", members_of(panel, y, spectrum.bin_hz),
                                 tenths_of(inspection::drawn_decibels(spectrum)))};
}

}  // namespace piae::classification
