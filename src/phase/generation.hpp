#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "artefact/reader.hpp"
#include "base/label.hpp"
#include "base/random.hpp"
#include "phase/cycle.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"
#include "twin/space.hpp"

namespace piae::phase {

/// How a window passes through the waveforms of two states: it starts at an angle of the first, and
/// from one sample on it goes on in the second, at the same strike angle but in another turn. So
/// the window repeats no known one, and yet its strikes keep their rhythm.
struct Passage {
  std::size_t start = 0;   ///< sample of the cycle at which the window starts, uniform
  std::size_t change = 0;  ///< sample of the window at which it changes to the second, uniform
  std::size_t turn = 0;    ///< strikes by which the second state is ahead then, uniform
};

/// Draws a passage for a window of `length` samples.
Passage draw_passage(const Cycle& cycle, std::size_t length, Stream& stream);

/// The window [length] that passes so through two cyclic waveforms of the same class. A start that
/// is j samples later gives the same window j samples earlier, except that the change stays at its
/// sample of the window.
std::vector<float> splice(std::span<const float> first, std::span<const float> second,
                          const Cycle& cycle, const Passage& passage, std::size_t length);

/// What a window is made of: two states (k~, c~) of its class, and how it passes through them.
struct Draw {
  twin::TwinPoint first;
  twin::TwinPoint second;
  Passage passage;
};

/// The windows that the decoder of a trained model makes of these draws for a class with a defect:
/// [draws, N] row by row, in the recordings' unit.
std::vector<float> decode(const artefact::Reader& model, Label label,
                          const std::vector<Draw>& draws, const twin::Engine& engine);

/// Makes `count` windows of each class with a defect, in the recordings' unit. For each it draws
/// two states from the histogram of the class's known (k~, c~) and a passage through them, and
/// decodes both states. The (k, c) that is stored with a window is that of the first state. Window
/// i of a class draws from the stream's child "<class>/<i>".
signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           const twin::Engine& engine);

}  // namespace piae::phase
