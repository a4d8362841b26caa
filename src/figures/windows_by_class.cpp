#include "figures/windows_by_class.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <functional>

#include "base/parallel.hpp"
#include "bearing/kinematics.hpp"
#include "figures/window_view.hpp"
#include "scoring/envelope.hpp"
#include "signal/roles.hpp"
#include "signal/window_set.hpp"

namespace piae::figures {

namespace {

using Eigen::Index;
using signal::DatasetInfo;
using signal::WindowSet;

/// Where windows come from, and what is shown of each fault class.
struct Origin {
  std::string name;
  std::vector<WindowView> views;
};

WindowSet read_windows(const std::filesystem::path& file, signal::Role role) {
  const artefact::Reader reader(file, "windows");
  signal::require_role(reader, role);
  WindowSet windows = signal::read_window_set(reader);
  signal::require_belonging(reader, role, windows);
  return windows;
}

std::vector<WindowView> views_of(const WindowSet& set, const ViewAxes& axes) {
  const std::vector<Label> labels = set.info.fault_labels();
  std::vector<WindowView> views(labels.size());
  parallel_for(labels.size(), [&](std::size_t i) {
    const scoring::Windows windows =
        scoring::windows_of(set, labels[i], set.count_of(labels[i])) * set.info.unit_m_per_s2;
    views[i] = view_of(windows, axes);
  });
  return views;
}

std::string decibels(double value) { return fmt::format("{:.1f}", value); }
std::string whole_decibels(double value) { return fmt::format("{:.0f}", value); }
std::string few_digits(double value) { return fmt::format("{:.4g}", value); }

/// The rows of one class.
class ClassRows {
 public:
  ClassRows(const std::vector<Origin>& origins, std::size_t of_class)
      : origins_(origins), of_class_(of_class), numbers_(header(origins)) {}

  void views(const ViewAxes& axes) {
    const WindowView& first = view(origins_.front());
    for (Index i = 0; i < first.low.size(); ++i) {
      const std::string ms = few_digits(axes.waveform_ms(i));
      add("waveform", "low", ms, "", [&](const WindowView& v) { return few_digits(v.low[i]); });
      add("waveform", "high", ms, "", [&](const WindowView& v) { return few_digits(v.high[i]); });
    }
    for (Index i = 0; i < first.spectrum_db.size(); ++i) {
      add("spectrum", "", few_digits(axes.spectrum_hz(i)), "",
          [&](const WindowView& v) { return decibels(v.spectrum_db[i]); });
    }
    for (Index i = 0; i < first.envelope_db.size(); ++i) {
      add("envelope", "", few_digits(axes.envelope_hz(i)), "",
          [&](const WindowView& v) { return decibels(v.envelope_db[i]); });
    }
    spectrogram(axes, first.spectrogram_db);
  }

  void lines(const DatasetInfo& info, signal::Defect own) {
    using signal::Defect;
    add("unit", info.unit_m_per_s2 == 1 ? "recordings" : "m/s2", "", "",
        [](const WindowView&) { return ""; });
    for (const Defect defect : {Defect::outer, Defect::inner, Defect::roller}) {
      const double line_hz = scoring::fault_line_hz(info, defect);
      const std::string name = name_of(defect);
      const double shaft_hz = info.tested_speed_rpm() / 60;
      for (int harmonic = 1; harmonic <= ViewAxes::harmonics; ++harmonic) {
        const double hz = harmonic * line_hz;
        line(defect == own ? "own-line" : "line", name, hz, harmonic);
        if (defect != own) continue;
        line("sideband", name, hz - shaft_hz, harmonic);
        line("sideband", name, hz + shaft_hz, harmonic);
      }
    }
  }

  [[nodiscard]] const Numbers& numbers() const { return numbers_; }

 private:
  static std::vector<std::string> header(const std::vector<Origin>& origins) {
    std::vector<std::string> names{"panel", "what", "x", "y"};
    for (const Origin& origin : origins) names.push_back(origin.name);
    return names;
  }

  static std::string name_of(signal::Defect defect) {
    return defect == signal::Defect::outer   ? "BPFO"
           : defect == signal::Defect::inner ? "BPFI"
                                             : "2BSF";
  }

  [[nodiscard]] const WindowView& view(const Origin& origin) const {
    return origin.views[of_class_];
  }

  void add(const std::string& panel, const std::string& what, const std::string& x,
           const std::string& y, const std::function<std::string(const WindowView&)>& value) {
    std::vector<std::string> row{panel, what, x, y};
    for (const Origin& origin : origins_) row.push_back(value(view(origin)));
    numbers_.row(row);
  }

  void spectrogram(const ViewAxes& axes, const Eigen::ArrayXXd& shape) {
    // The mean is taken away, so nothing is at 0 Hz.
    for (Index time = 0; time < shape.rows(); ++time) {
      for (Index bin = 1; bin < shape.cols(); ++bin) {
        add("spectrogram", "", few_digits(axes.spectrogram_ms(time)),
            few_digits(axes.spectrogram_hz(bin)),
            [&](const WindowView& v) { return whole_decibels(v.spectrogram_db(time, bin)); });
      }
    }
  }

  void line(const std::string& panel, const std::string& name, double hz, int harmonic) {
    add(panel, name, few_digits(hz), std::to_string(harmonic),
        [](const WindowView&) { return ""; });
  }

  const std::vector<Origin>& origins_;
  std::size_t of_class_;
  Numbers numbers_;
};

std::vector<Origin> all_origins(Source& source, const WindowSet& real, const ViewAxes& axes) {
  const std::int64_t seed = source.shown_seed();
  std::vector<Origin> origins{{"real", views_of(real, axes)}};
  for (const std::string& method : source.grid().scored) {
    const auto file = source.layout().generated_windows(method, seed);
    if (!source.has(method, seed, file)) continue;
    const WindowSet generated = read_windows(file, signal::Role::generated);
    if (generated.length != real.length ||
        generated.info.classes.size() != real.info.classes.size()) {
      throw Error(Exit::bad_input, file.string() + ": is not of the dataset of D.h5");
    }
    origins.push_back({method, views_of(generated, axes)});
  }
  return origins;
}

}  // namespace

std::vector<Picture> windows_by_class(Source& source) {
  const WindowSet real =
      read_windows(source.layout().real_windows(source.shown_seed()), signal::Role::hidden);
  const ViewAxes axes(real.info, static_cast<Index>(real.length));
  const std::vector<Origin> origins = all_origins(source, real, axes);
  std::vector<Picture> pictures;
  for (const Label label : real.info.fault_labels()) {
    const signal::ClassInfo& of_class = real.info.class_of(label);
    ClassRows rows(origins, pictures.size());
    rows.views(axes);
    rows.lines(real.info, of_class.defect);
    pictures.push_back({of_class.name, rows.numbers()});
  }
  return pictures;
}

}  // namespace piae::figures
