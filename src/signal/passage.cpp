#include "signal/passage.hpp"

#include <cmath>

namespace piae::signal {

Passage draw_passage(const Cycle& cycle, std::size_t length, Stream& stream) {
  return {.start = stream.below(cycle.samples),
          .change = stream.below(length),
          .turn = stream.below(cycle.impacts)};
}

std::size_t sample_after_change(const Cycle& first, const Cycle& second, const Passage& passage) {
  const auto at = static_cast<double>(passage.start + passage.change);
  const auto same_angle =
      static_cast<std::size_t>(std::lround(at * second.period() / first.period()));
  return same_angle + second.offset_of_impact(passage.turn);
}

}  // namespace piae::signal
