#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "signal/cycle.hpp"

namespace piae::signal {

/// Path of a window through two cyclic waveforms of a class. It starts at an angle of the first and
/// changes at one sample to the second, at the same impact angle but in another turn. So the window
/// repeats no known window, but its impacts stay in phase.
struct Passage {
  std::size_t start = 0;   ///< first sample, in the first cycle; uniform
  std::size_t change = 0;  ///< sample of the window where the second starts; uniform
  std::size_t turn = 0;    ///< impacts by which the second is ahead; uniform
};

/// Draws a passage for a window of `length` samples.
Passage draw_passage(const Cycle& cycle, std::size_t length, Stream& stream);

/// A cyclic waveform that begins at an impact, or at the same angle as its partner waveform.
template <class T>
struct Waveform {
  std::span<const T> samples;
  Cycle cycle;
};

/// Returns the sample of the second cycle with which a window continues after the change.
std::size_t sample_after_change(const Cycle& first, const Cycle& second, const Passage& passage);

/// Returns the window [length] that passes through two waveforms. A start j samples later gives the
/// same window j samples earlier, but the change stays at its sample of the window.
template <class T>
std::vector<T> splice(const Waveform<T>& first, const Waveform<T>& second, const Passage& passage,
                      std::size_t length) {
  std::vector<T> window = read(first.samples, passage.start, passage.change);
  const std::size_t ahead = sample_after_change(first.cycle, second.cycle, passage);
  const std::vector<T> rest = read(second.samples, ahead, length - passage.change);
  window.insert(window.end(), rest.begin(), rest.end());
  return window;
}

}  // namespace piae::signal
