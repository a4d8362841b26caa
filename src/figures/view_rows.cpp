#include "figures/view_rows.hpp"

#include <spdlog/fmt/fmt.h>

namespace piae::figures {

namespace {

using Eigen::Index;

std::string decibels(double value) { return fmt::format("{:.1f}", value); }
std::string whole_decibels(double value) { return fmt::format("{:.0f}", value); }

std::vector<std::string> header_of(const std::vector<NamedView>& sets) {
  std::vector<std::string> names{"panel", "what", "x", "y"};
  for (const NamedView& set : sets) names.push_back(set.name);
  return names;
}

}  // namespace

ViewRows::ViewRows(std::vector<NamedView> sets, const ViewAxes& axes)
    : sets_(std::move(sets)), axes_(axes), numbers_(header_of(sets_)) {}

void ViewRows::waveforms() {
  for (Index i = 0; i < first().low.size(); ++i) {
    const std::string ms = few_digits(axes_.waveform_ms(i));
    values("waveform", "low", ms, "", [&](const WindowView& v) { return few_digits(v.low[i]); });
    values("waveform", "high", ms, "", [&](const WindowView& v) { return few_digits(v.high[i]); });
  }
}

void ViewRows::spectra() {
  for (Index i = 0; i < first().spectrum_db.size(); ++i) {
    values("spectrum", "", few_digits(axes_.spectrum_hz(i)), "",
           [&](const WindowView& v) { return decibels(v.spectrum_db[i]); });
  }
  for (Index i = 0; i < first().envelope_db.size(); ++i) {
    values("envelope", "", few_digits(axes_.envelope_hz(i)), "",
           [&](const WindowView& v) { return decibels(v.envelope_db[i]); });
  }
}

void ViewRows::spectrograms() {
  const Eigen::ArrayXXd& shape = first().spectrogram_db;
  // The mean is removed, so 0 Hz is empty.
  for (Index time = 0; time < shape.rows(); ++time) {
    for (Index bin = 1; bin < shape.cols(); ++bin) {
      values("spectrogram", "", few_digits(axes_.spectrogram_ms(time)),
             few_digits(axes_.spectrogram_hz(bin)),
             [&](const WindowView& v) { return whole_decibels(v.spectrogram_db(time, bin)); });
    }
  }
}

void ViewRows::row(const std::string& panel, const std::string& what, const std::string& x,
                   const std::string& y, const std::vector<std::string>& of_sets) {
  std::vector<std::string> fields{panel, what, x, y};
  fields.insert(fields.end(), of_sets.begin(), of_sets.end());
  numbers_.row(fields);
}

void ViewRows::row(const std::string& panel, const std::string& what, const std::string& x,
                   const std::string& y) {
  row(panel, what, x, y, std::vector<std::string>(sets_.size()));
}

void ViewRows::values(const std::string& panel, const std::string& what, const std::string& x,
                      const std::string& y,
                      const std::function<std::string(const WindowView&)>& value) {
  std::vector<std::string> of_sets;
  for (const NamedView& set : sets_) of_sets.push_back(value(set.view));
  row(panel, what, x, y, of_sets);
}

}  // namespace piae::figures
