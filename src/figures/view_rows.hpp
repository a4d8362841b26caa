#pragma once

#include <functional>
#include <string>
#include <vector>

#include "figures/numbers.hpp"
#include "figures/window_view.hpp"

namespace piae::figures {

/// Views of a named set of windows.
struct NamedView {
  std::string name;
  WindowView view;
};

/// Numbers of a picture that shows several sets of windows along the same axes. Columns:
/// panel,what,x,y, and one for each set. The meaning of x, y and the values depends on the panel.
class ViewRows {
 public:
  /// Needs at least one set.
  ViewRows(std::vector<NamedView> sets, const ViewAxes& axes);

  /// Adds waveform: ms; the lowest or the highest of some samples, according to `what`.
  void waveforms();
  /// Adds spectrum and envelope: Hz; mean amplitude in dB.
  void spectra();
  /// Adds spectrogram: ms and Hz; amplitude of the shown window in dB.
  void spectrograms();
  /// Adds any other row, with a value for each set, or none.
  void row(const std::string& panel, const std::string& what, const std::string& x,
           const std::string& y, const std::vector<std::string>& of_sets);
  void row(const std::string& panel, const std::string& what, const std::string& x,
           const std::string& y);

  [[nodiscard]] const Numbers& numbers() const { return numbers_; }

 private:
  [[nodiscard]] const WindowView& first() const { return sets_.front().view; }
  void values(const std::string& panel, const std::string& what, const std::string& x,
              const std::string& y, const std::function<std::string(const WindowView&)>& value);

  std::vector<NamedView> sets_;
  ViewAxes axes_;
  Numbers numbers_;
};

}  // namespace piae::figures
