#pragma once

#include <cstddef>
#include <cstdint>

namespace piae {

/// Class of a window: an index into DatasetInfo::classes, as artefacts store it.
using Label = std::int32_t;

/// Returns a label as an index of a container.
constexpr std::size_t index_of(Label label) { return static_cast<std::size_t>(label); }

}  // namespace piae
