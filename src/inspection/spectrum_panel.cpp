#include "inspection/spectrum_panel.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "spectra/floors.hpp"

namespace piae::inspection {

namespace {

constexpr double lowest_db = -10;
constexpr int marked_harmonics = 3;
constexpr double name_height = 11;

/// Outer, inner, roller: the order of FaultLines.
const std::array<Stroke, 3> line_strokes{Stroke{"#0072B2", 1, ""}, Stroke{"#D55E00", 1, "7 3"},
                                         Stroke{"#009E73", 1, "2 2"}};

bool lines_are_known(const FaultLines& lines) { return lines.front().hz > 0; }

/// Returns the end of the shown part: slightly above the third harmonic of the highest line.
double highest_shown_hz(const FaultLines& lines, double shaft_hz) {
  constexpr double shown_turns = 20;  // without lines
  if (!lines_are_known(lines)) return shown_turns * shaft_hz;
  return 3.5 * std::ranges::max(lines, {}, &FaultLine::hz).hz;
}

}  // namespace

void keep_shown_part(EnvelopeSpectrum& spectrum, const FaultLines& lines, double shaft_hz) {
  const double bins = std::ceil(highest_shown_hz(lines, shaft_hz) / spectrum.bin_hz);
  if (bins < static_cast<double>(spectrum.power.size())) {
    spectrum.power.resize(static_cast<std::size_t>(bins));
  }
}

std::vector<double> drawn_decibels(const EnvelopeSpectrum& spectrum) {
  const double floor = std::max(spectra::median(spectrum.power), spectrum.rounding);
  std::vector<double> decibels;
  for (const double power : spectrum.power) {
    decibels.push_back(
        std::max(lowest_db, 10 * std::log10(std::max(power, spectrum.rounding) / floor)));
  }
  return decibels;
}

// Each defect has its own row of names above the panel. A higher frequency gets a row closer to the
// panel, so that no line crosses a name to its left.
void draw_fault_lines(Svg& svg, const FaultLines& lines, signal::Defect own, int harmonics,
                      const Axis& x, const Panel& panel) {
  if (!lines_are_known(lines)) return;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const FaultLine& line = lines.at(i);
    const bool is_own = line.fault_type == own;
    Stroke stroke = line_strokes.at(i);
    stroke.width = is_own ? 2.4 : 1;
    const auto higher =
        std::ranges::count_if(lines, [&](const FaultLine& other) { return other.hz > line.hz; });
    const double name_y = panel.top - 4 - name_height * static_cast<double>(higher);
    for (int n = 1; n <= harmonics; ++n) {
      const double at = x.at(n * line.hz);
      if (at > x.to) break;
      svg.line({at, name_y + 1}, {at, panel.top + panel.height}, stroke);
      const std::string name = n == 1 ? line_name(line.fault_type) : std::to_string(n);
      svg.text({at + 3, name_y}, name, Anchor::start, 10, is_own);
    }
  }
}

void draw_line_legend(Svg& svg, const FaultLines& lines, Point at, const std::string& thick) {
  if (!lines_are_known(lines)) return;
  for (std::size_t i = 0; i < line_strokes.size(); ++i) {
    Stroke stroke = line_strokes.at(i);
    stroke.width = 2;
    svg.line({at.x, at.y - 4}, {at.x + 34, at.y - 4}, stroke);
    svg.text({at.x + 40, at.y}, line_name(lines.at(i).fault_type));
    at.x += 92;
  }
  svg.text(at, "2, 3: harmonics; thick: " + thick);
}

Axis draw_envelope_spectrum(Svg& svg, const EnvelopeSpectrum& spectrum, const FaultLines& lines,
                            signal::Defect own, const Panel& panel) {
  if (spectrum.power.empty()) return {lowest_db, 20, panel.top + panel.height, panel.top};
  const std::vector<double> decibels = drawn_decibels(spectrum);
  const double highest_hz = static_cast<double>(spectrum.power.size()) * spectrum.bin_hz;
  // The first bins hold the taper's remainder of the mean.
  const auto first =
      std::min(decibels.size() - 1,
               static_cast<std::size_t>(std::lround(2 * spectrum.resolution_hz / spectrum.bin_hz)));
  const double highest_db =
      *std::max_element(decibels.begin() + static_cast<std::ptrdiff_t>(first), decibels.end());
  const Axis x{0, highest_hz, panel.left, panel.left + panel.width};
  const Axis y{lowest_db, std::max(20.0, highest_db + 2), panel.top + panel.height, panel.top};
  for (int db = 0; db <= y.high; db += 10) {
    svg.line({x.from, y.at(db)}, {x.to, y.at(db)}, grid_stroke);
    if (db % 20 == 0) {
      svg.text({x.from - 5, y.at(db) + 4}, std::to_string(db), Anchor::end);
    }
  }
  const double step_hz = tick_step(highest_hz);
  for (int tick = 0; tick * step_hz < highest_hz; ++tick) {
    const double hz = tick * step_hz;
    svg.text({x.at(hz), panel.top + panel.height + 14}, fmt::format("{:g}", hz), Anchor::middle);
  }
  svg.text({x.to, panel.top + panel.height + 14}, "Hz", Anchor::end);
  draw_fault_lines(svg, lines, own, marked_harmonics, x, panel);
  std::vector<double> shown = decibels;
  std::fill(shown.begin(), shown.begin() + static_cast<std::ptrdiff_t>(first), lowest_db);
  svg.polyline(trace_of(shown, spectrum.bin_hz, x, y), signal_stroke);
  svg.frame({x.from, panel.top}, panel.width, panel.height);
  return y;
}

}  // namespace piae::inspection
