#pragma once

#include <cstddef>
#include <vector>

#include "artefact/reader.hpp"
#include "base/label.hpp"
#include "base/random.hpp"
#include "signal/passage.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"
#include "twin/space.hpp"

namespace piae::phase {

/// Parameters of a window: two states (k~, c~) of its class, and the passage through them.
struct Draw {
  twin::TwinPoint first;
  twin::TwinPoint second;
  signal::Passage passage;
};

/// Returns the windows that the decoder of a trained model makes from these draws, for a class with
/// a defect: [draws, N] row by row, in the recordings' unit.
std::vector<float> decode(const artefact::Reader& model, Label label,
                          const std::vector<Draw>& draws, const twin::Engine& engine);

/// Makes `count` windows of each class with a defect, in the recordings' unit. For each window,
/// draws two states from the histogram of the class's known (k~, c~) and a passage through them,
/// and decodes both states. Stores with each window the (k, c) of the first state and the start
/// angle of the passage, counted from the start of the class's reference window. Window i of a
/// class draws from the stream's child "<class>/<i>".
signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                           const twin::Engine& engine);

}  // namespace piae::phase
