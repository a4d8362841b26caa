#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "signal/cycle.hpp"

namespace piae::signal {

/// How a window passes through two cyclic waveforms of a class: it starts at an angle of the first,
/// and from one sample on it goes on in the second, at the same strike angle but in another turn.
/// So the window repeats no known one, and yet its strikes keep their rhythm.
struct Passage {
  std::size_t start = 0;   ///< sample of the first cycle at which the window starts, uniform
  std::size_t change = 0;  ///< sample of the window at which it changes to the second, uniform
  std::size_t turn = 0;    ///< strikes by which the second is ahead then, uniform
};

/// Draws a passage for a window of `length` samples.
Passage draw_passage(const Cycle& cycle, std::size_t length, Stream& stream);

/// A cyclic waveform that begins at a strike, or at the same angle after one as the other waveform
/// that it is joined with.
template <class T>
struct Waveform {
  std::span<const T> samples;
  Cycle cycle;
};

/// The sample of the second cycle at which a window goes on after its change.
std::size_t sample_after_change(const Cycle& first, const Cycle& second, const Passage& passage);

/// The window [length] that passes so through two waveforms. A start that is j samples later gives
/// the same window j samples earlier, except that the change stays at its sample of the window.
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
