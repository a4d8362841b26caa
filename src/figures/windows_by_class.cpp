#include "figures/windows_by_class.hpp"

#include "base/parallel.hpp"
#include "bearing/impact_frequency.hpp"
#include "figures/line_name.hpp"
#include "figures/stored_windows.hpp"
#include "figures/view_rows.hpp"

namespace piae::figures {

namespace {

using Eigen::Index;
using signal::DatasetInfo;
using signal::Defect;
using signal::WindowSet;

/// Source of some windows, and their views for each fault class.
struct Origin {
  std::string name;
  std::vector<WindowView> views;
};

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

std::vector<Origin> all_origins(Source& source, const WindowSet& real, const ViewAxes& axes) {
  std::vector<Origin> origins{{"real", views_of(real, axes)}};
  for (const std::string& method : source.grid().scored) {
    const auto generated = read_generated(source, method, real);
    if (generated) origins.push_back({method, views_of(*generated, axes)});
  }
  return origins;
}

std::vector<NamedView> views_of_class(const std::vector<Origin>& origins, std::size_t of_class) {
  std::vector<NamedView> views;
  for (const Origin& origin : origins) views.push_back({origin.name, origin.views[of_class]});
  return views;
}

void add_line(ViewRows& rows, const DatasetInfo& info, Defect defect, bool is_own) {
  const double line_hz =
      bearing::impact_frequency_hz(info.bearing, defect, info.tested_speed_rpm());
  const double shaft_hz = info.tested_speed_rpm() / 60;
  const std::string name = line_name(defect);
  for (int harmonic = 1; harmonic <= ViewAxes::harmonics; ++harmonic) {
    const double hz = harmonic * line_hz;
    const std::string number = std::to_string(harmonic);
    rows.row(is_own ? "own-line" : "line", name, few_digits(hz), number);
    if (!is_own) continue;
    rows.row("sideband", name, few_digits(hz - shaft_hz), number);
    rows.row("sideband", name, few_digits(hz + shaft_hz), number);
  }
}

Numbers view_numbers(ViewRows rows, const DatasetInfo& info, Defect own) {
  rows.waveforms();
  rows.spectra();
  rows.spectrograms();
  rows.row("unit", info.unit_m_per_s2 == 1 ? "recordings" : "m/s2", "", "");
  if (!info.has_bearing) return rows.numbers();
  for (const Defect defect : {Defect::outer, Defect::inner, Defect::roller}) {
    add_line(rows, info, defect, defect == own);
  }
  return rows.numbers();
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
    const ViewRows rows(views_of_class(origins, pictures.size()), axes);
    pictures.push_back({of_class.name, view_numbers(rows, real.info, of_class.defect)});
  }
  return pictures;
}

}  // namespace piae::figures
