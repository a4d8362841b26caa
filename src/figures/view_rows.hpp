#pragma once

#include <functional>
#include <string>
#include <vector>

#include "figures/numbers.hpp"
#include "figures/window_view.hpp"

namespace piae::figures {

/// A set of windows by its name, and what is shown of it.
struct NamedView {
  std::string name;
  WindowView view;
};

/// The numbers of a picture that shows several sets of windows along the same axes. Columns:
/// panel,what,x,y, and one for each set. What x, y and the values of the sets are depends on the
/// panel.
class ViewRows {
 public:
  /// There must be a set.
  ViewRows(std::vector<NamedView> sets, const ViewAxes& axes);

  /// waveform: ms; the lowest or the highest of some samples, as `what` says.
  void waveforms();
  /// spectrum and envelope: Hz; mean amplitude in dB.
  void spectra();
  /// spectrogram: ms and Hz; amplitude of the window shown in dB.
  void spectrograms();
  /// Anything else, with a value for each set, or none.
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
