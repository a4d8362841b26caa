#include "classification/picture.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "inspection/drawing.hpp"
#include "inspection/spectrum_panel.hpp"
#include "inspection/svg.hpp"

namespace piae::classification {

namespace {

using inspection::Anchor;
using inspection::Axis;
using inspection::Panel;
using inspection::Svg;
using signal::DatasetInfo;

constexpr double page_width = 1080;
constexpr double top = 64;        // title and legend
constexpr double panel_top = 58;  // in a row: its title and the names of the lines
constexpr double least_panel_height = 96;
constexpr double class_height = 12;
constexpr double below_panel = 34;
constexpr double time_left = 90;
constexpr double time_width = 380;
constexpr double spectrum_left = 530;
constexpr double spectrum_width = 530;

constexpr const char* unknown_colour = "#999999";
constexpr const char* healthy_colour = "#009E73";
// From half certain to certain. Faults are red, healthy windows green, so that a glance separates
// them.
constexpr std::array fault_colours{"#f4c7a5", "#ee9f6b", "#e0702f", "#D55E00"};

std::string colour_of(bool healthy, double probability) {
  if (healthy) return healthy_colour;
  const double place = (probability - 0.5) / 0.5 * static_cast<double>(fault_colours.size());
  const auto last = static_cast<double>(fault_colours.size() - 1);
  return fault_colours.at(static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last)));
}

double panel_height_of(const DatasetInfo& info) {
  return std::max(least_panel_height, class_height * static_cast<double>(info.classes.size() + 1));
}

void draw_time_line(Svg& svg, const Verdict& verdict, const DatasetInfo& info, std::size_t length,
                    const Panel& panel) {
  const std::size_t classes = info.classes.size();
  const double row = panel.height / static_cast<double>(classes + 1);
  const double window_s = static_cast<double>(length) / info.sample_rate_hz;
  const Axis x{0, verdict.start_s.back() + window_s, panel.left, panel.left + panel.width};
  for (std::size_t k = 0; k <= classes; ++k) {
    const double y = panel.top + row * static_cast<double>(k);
    svg.line({x.from, y}, {x.to, y}, inspection::grid_stroke);
    svg.text({x.from - 5, y + row / 2 + 3.5}, k < classes ? info.classes[k].name : "unknown",
             Anchor::end, 10);
  }
  for (std::size_t i = 0; i < verdict.start_s.size(); ++i) {
    const std::size_t named = index_of(verdict.predictions.labels[i]);
    const bool unknown = verdict.is_unknown(i);
    const double next_s = i + 1 < verdict.start_s.size() ? verdict.start_s[i + 1] : x.high;
    const double end_s = std::min(next_s, verdict.start_s[i] + window_s);
    const std::string colour =
        unknown ? unknown_colour
                : colour_of(info.classes[named].defect == signal::Defect::none,
                            verdict.predictions.probabilities[i * classes + named]);
    svg.area({x.at(verdict.start_s[i]),
              panel.top + row * static_cast<double>(unknown ? classes : named) + 1},
             x.at(end_s) - x.at(verdict.start_s[i]), row - 2, colour);
  }
  const double step = inspection::tick_step(x.high);
  for (int tick = 0; tick * step < x.high; ++tick) {
    svg.text({x.at(tick * step), panel.top + panel.height + 14}, fmt::format("{:g}", tick * step),
             Anchor::middle);
  }
  svg.text({x.to + 8, panel.top + panel.height + 14}, "s");
  svg.frame({panel.left, panel.top}, panel.width, panel.height);
}

std::string title_of(const Verdict& verdict, const DatasetInfo& info) {
  const std::string true_class =
      verdict.recording.true_class.empty()
          ? ""
          : fmt::format(" (described as {})", verdict.recording.true_class);
  if (verdict.unknown) {
    return fmt::format("{}{}: unknown, {:.0f} % of its windows differ from all trained classes",
                       verdict.recording.name, true_class, 100 * verdict.share_unknown);
  }
  return fmt::format("{}{}: {}, {:.0f} % sure", verdict.recording.name, true_class,
                     info.class_of(verdict.label).name, 100 * verdict.probability);
}

}  // namespace

std::string picture_of(const std::vector<Verdict>& verdicts, const DatasetInfo& info,
                       std::size_t length) {
  const double height = panel_height_of(info);
  const double row_height = panel_top + height + below_panel;
  Svg svg(page_width, top + row_height * static_cast<double>(verdicts.size()) + 8,
          "predicted classes and envelope spectra");
  svg.text({time_left, 24}, "predicted class of each window", Anchor::start, 16, true);
  svg.text({time_left, 46}, "darker: more probable; grey: unknown");
  svg.text({spectrum_left, 46}, "envelope spectrum, dB over its median");
  if (!verdicts.empty()) {
    draw_line_legend(svg, verdicts.front().lines, {spectrum_left, 24}, "the predicted fault");
  }
  double y = top;
  for (const Verdict& verdict : verdicts) {
    svg.text({time_left, y + 16}, title_of(verdict, info), Anchor::start, 12, true);
    draw_time_line(
        svg, verdict, info, length,
        {.left = time_left, .top = y + panel_top, .width = time_width, .height = height});
    draw_envelope_spectrum(
        svg, verdict.envelope, verdict.lines,
        verdict.unknown ? signal::Defect::none : info.class_of(verdict.label).defect,
        {.left = spectrum_left, .top = y + panel_top, .width = spectrum_width, .height = height});
    y += row_height;
  }
  return svg.str();
}

}  // namespace piae::classification
