#include "classification/recording_page.hpp"

#include <spdlog/fmt/fmt.h>

#include "bearing/defect.hpp"
#include "bearing/kinematics.hpp"
#include "classification/line_evidence.hpp"
#include "classification/page_charts.hpp"
#include "classification/page_words.hpp"
#include "classification/recording_page_style.hpp"
#include "text/html_page.hpp"

namespace piae::classification {

namespace {

using signal::DatasetInfo;
using signal::Defect;
using text::element;
using text::Html;

Html fact(const std::string& name, const std::string& value) {
  return element("dt", name) + element("dd", value);
}

std::string shown_speed(const Recording& recording) {
  if (!recording.shaft) return "the recording is too short to show it";
  return fmt::format("{:.1f} rpm{}", recording.shaft->rpm,
                     recording.shaft->is_certain() ? "" : ", uncertain");
}

Html facts_of(const Verdict& verdict, const DatasetInfo& info) {
  const Recording& recording = verdict.recording;
  const double length_s = static_cast<double>(recording.signal.size()) / info.sample_rate_hz;
  Html facts =
      fact("Shaft speed given", fmt::format("{:g} rpm", recording.given_speed_rpm)) +
      fact("Shaft speed in the signal", shown_speed(recording)) +
      fact("Shaft speed used", fmt::format("{:g} rpm ({:.2f} Hz)", recording.shaft_speed_rpm,
                                           recording.shaft_speed_rpm / 60)) +
      fact("Length", fmt::format("{:.2f} s, {:.0f} turns", length_s,
                                 length_s * recording.shaft_speed_rpm / 60)) +
      fact("Sample rate", fmt::format("{:g} Hz", info.sample_rate_hz));
  if (!recording.true_class.empty()) facts += fact("Described as", recording.true_class);
  return element("dl", facts);
}

Html number_cell(const std::string& number, bool present) {
  return element("td", {{"class", present ? "present" : "absent"}}, number);
}

Html side_bands_cells(const std::optional<SideBands>& bands) {
  if (!bands) return element("td", "-") + element("td", "-");
  return element("td", fmt::format("\u00b1{:.2f} Hz", bands->spacing_hz)) +
         number_cell(fmt::format("{:+.1f}, {:+.1f}", bands->below_db, bands->above_db),
                     bands->present() > 0);
}

Html evidence_row(const LineEvidence& evidence, double shaft_hz) {
  const inspection::FaultLine& line = evidence.line;
  Html cells = element("th", {{"scope", "row"}}, inspection::line_name(line.fault_type)) +
               element("td", place_of(line.fault_type)) +
               element("td", fmt::format("{:.1f}", line.hz)) +
               element("td", fmt::format("{:.3f}", line.hz / shaft_hz));
  if (!line.db) {
    return element("tr", cells + element("td", {{"colspan", "8"}}, "too short to measure"));
  }
  cells += element("td", fmt::format("{:.1f}", evidence.found_hz));
  for (const int number : {1, 2, 3}) {
    cells += number_cell(
        fmt::format("{:+.1f}", evidence.harmonics_db.at(static_cast<std::size_t>(number - 1))),
        evidence.has_harmonic(number));
  }
  cells += number_cell(fmt::format("{:+.1f}", *line.db), line.stands_out) +
           element("td", fmt::format("{:.1f}", line.noise_db)) +
           side_bands_cells(evidence.side_bands);
  return element("tr", cells);
}

Html evidence_table(const std::array<LineEvidence, 3>& evidence, double shaft_hz) {
  Html header;
  for (const char* const name :
       {"line", "of the", "expected, Hz", "order", "found, Hz", "1\u00d7, dB", "2\u00d7, dB",
        "3\u00d7, dB", "mean, dB", "noise limit, dB", "side bands at", "below, above, dB"}) {
    header += element("th", {{"scope", "col"}}, name);
  }
  Html rows;
  for (const LineEvidence& each : evidence) rows += evidence_row(each, shaft_hz);
  return element("table", element("caption",
                                  "Characteristic bearing frequencies in the envelope spectrum, "
                                  "heights over its floor; bold: present") +
                              element("thead", element("tr", header)) + element("tbody", rows));
}

Html paragraphs(const std::vector<std::string>& texts) {
  Html all;
  for (const std::string& each : texts) all += element("p", each);
  return all;
}

Html verdict_section(const Verdict& verdict, const PageOrigin& origin) {
  const std::array<LineEvidence, 3> evidence = line_evidence(verdict, origin.info);
  Html content = element("h2", "Verdict: " + verdict_heading(verdict, origin.info)) +
                 element("p", certainty_sentences(verdict, origin.is_calibrated)) +
                 paragraphs(reasons_of(verdict, origin.info, evidence));
  if (origin.info.has_bearing) {
    content += evidence_table(evidence, verdict.recording.shaft_speed_rpm / 60);
  }
  Html steps;
  for (const std::string& step : next_steps_of(verdict, origin.info)) steps += element("li", step);
  content += element("h2", "What to do next") + element("ol", steps) +
             element("p",
                     "The page names a fault, not its severity: that needs the trend of this "
                     "machine, or limits for it.");
  return element("section", content);
}

Html figure(const std::string& id, const std::string& caption, const Chart& chart) {
  return element("figure", {{"id", id}},
                 element("figcaption", caption) + Html::markup(chart.drawing));
}

/// Returns controls of the script, which shows them.
Html controls(double shaft_hz, double cage_hz) {
  Html options = element("option", {{"value", fmt::format("{:.6g}", shaft_hz)}},
                         fmt::format("shaft speed, {:.2f} Hz", shaft_hz));
  if (cage_hz > 0) {
    options += element("option", {{"value", fmt::format("{:.6g}", cage_hz)}},
                       fmt::format("cage speed, {:.2f} Hz", cage_hz));
  }
  return element(
      "div", {{"id", "controls"}, {"hidden", ""}},
      element("label",
              Html("Side bands at the ") + element("select", {{"id", "spacing"}}, options)) +
          element("label", text::void_element("input", {{"id", "bands"}, {"type", "checkbox"}}) +
                               " show (or hold Shift)") +
          element(
              "span",
              "Cursor: mouse, or click a chart and press the arrow keys; dashes: harmonics 2 to "
              "8. Turn the wheel to zoom, double-click to see all."));
}

double cage_hz_of(const Verdict& verdict, const DatasetInfo& info) {
  if (!info.has_bearing) return 0;
  return bearing::fault_frequencies(info.bearing, verdict.recording.shaft_speed_rpm).cage_hz;
}

/// Returns the fault lines as JSON.
std::string lines_json(const Verdict& verdict, const DatasetInfo& info) {
  std::string text;
  if (info.has_bearing) {
    for (const inspection::FaultLine& line : verdict.lines) {
      text += fmt::format("{}[\"{}\",{:.6g}]", text.empty() ? "" : ",",
                          inspection::line_name(line.fault_type), line.hz);
    }
  }
  return "[" + text + "]";
}

Html charts_of(const Verdict& verdict, const DatasetInfo& info) {
  const double shaft_hz = verdict.recording.shaft_speed_rpm / 60;
  const Defect own = verdict.unknown ? Defect::none : info.class_of(verdict.label).defect;
  const Chart wave = waveform_chart(verdict, info);
  const Chart amplitude = amplitude_chart(verdict, info, own);
  const Chart envelope = envelope_chart(verdict, own);
  // Contains only numbers and names of lines, so nothing that could end the element.
  const std::string numbers = fmt::format(
      "{{\"shaft_hz\":{:.6g},\"lines\":{},\n\"waveform\":{},\n\"spectrum\":{},\n"
      "\"envelope\":{}}}",
      shaft_hz, lines_json(verdict, info), wave.numbers, amplitude.numbers, envelope.numbers);
  return controls(shaft_hz, cage_hz_of(verdict, info)) +
         figure("waveform",
                "Waveform: lowest and highest sample on each pixel, in units of the "
                "recording",
                wave) +
         figure("spectrum", "Amplitude spectrum: mean over Hann windows, dB re 1 unit (RMS)",
                amplitude) +
         figure("envelope",
                "Envelope (demodulated) spectrum: dB over its median; 2, 3: harmonics "
                "of a line; thick: the predicted fault",
                envelope) +
         element("script", {{"type", "application/json"}, {"id", "numbers"}},
                 Html::markup(numbers));
}

Html origin_section(const std::string& words) {
  return element("footer", element("p", "Classified " + words));
}

}  // namespace

std::string recording_page(const Verdict& verdict, const PageOrigin& origin) {
  const std::string& name = verdict.recording.name;
  const Html body =
      element("main", {{"id", "content"}},
              element("header", element("h1", name) + facts_of(verdict, origin.info)) +
                  verdict_section(verdict, origin) + charts_of(verdict, origin.info) +
                  origin_section(origin.words));
  return text::document(
      name, {.css = recording_page_style::css, .script = recording_page_style::script}, body);
}

}  // namespace piae::classification
