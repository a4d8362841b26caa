#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "artefact/reader.hpp"
#include "base/random.hpp"
#include "phase/cycle.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"
#include "twin/space.hpp"

namespace piae::phase {

/// One way through the twin space that a window takes: it starts at an angle of the first state,
/// and from one sample on goes on in the second, at the same strike angle of another turn. So a
/// window does not repeat a known one, and its strikes keep their rhythm.
struct Passage {
  std::size_t start = 0;   ///< sample of the cycle, uniform: the angle at which the window starts
  std::size_t change = 0;  ///< sample of the window, uniform
  std::size_t turn = 0;    ///< strikes by which the second state is ahead, uniform
};

/// Draws a passage through a cycle of `strikes` strikes for a window of `length` samples.
Passage draw_passage(const Cycle& cycle, std::size_t length, Stream& stream);

/// The window of a passage through two cyclic waveforms of the same class. A later start by j
/// samples is the same window j samples later, apart from the change, which stands where it stands
/// in the window.
std::vector<float> pass(std::span<const float> first, std::span<const float> second,
                        const Cycle& cycle, const Passage& passage, std::size_t length);

/// What a window is made of: two states (k~, c~) of its class, and the way through them.
struct Draw {
  twin::TwinPoint first;
  twin::TwinPoint second;
  Passage passage;
};

/// The windows of these draws in the recordings' unit, of one class with a defect, [draws, N] row
/// by row, from the decoder of a trained model.
std::vector<float> decode(const artefact::Reader& model, std::size_t label,
                          const std::vector<Draw>& draws, const twin::Engine& engine);

/// `count` windows of each class with a defect, in the recordings' unit: two states from the
/// histogram of the class's known (k~, c~) and a passage each, decoded. The (k, c) that are stored
/// are those of the first state. Window i of a class draws from the stream's child "<class>/<i>".
signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           const twin::Engine& engine);

}  // namespace piae::phase
