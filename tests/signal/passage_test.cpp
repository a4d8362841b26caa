#include "signal/passage.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace piae::signal {
namespace {

std::vector<float> counting_from(float first, std::size_t count) {
  std::vector<float> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = first + static_cast<float>(i);
  return all;
}

// A later start shifts the window; the change between waveforms stays at its sample.
TEST(Splice, StartsAtTheAngleAndKeepsTheImpactRate) {
  const std::vector<float> first = counting_from(0, 30);
  const std::vector<float> second = counting_from(100, 30);
  const Cycle cycle{30, 3, 4};
  const auto window_from = [&](std::size_t start) {
    return splice(Waveform<float>{first, cycle}, Waveform<float>{second, cycle},
                  {.start = start, .change = 4, .turn = 2}, 8);
  };
  const std::vector<float> window = window_from(28);
  // 28 29 0 1 of the first; then, 2 impacts of 10 samples ahead, 2 + 20 ... of the second.
  EXPECT_EQ(window, (std::vector<float>{28, 29, 0, 1, 122, 123, 124, 125}));
  const std::vector<float> later = window_from(29);
  for (const std::size_t i : {0U, 1U, 2U, 4U, 5U, 6U}) EXPECT_EQ(later[i], window[i + 1]) << i;
}

TEST(Splice, KeepsThePhaseIfPeriodsDiffer) {
  const std::vector<float> first = counting_from(0, 30);     // impacts at 0, 10, 20
  const std::vector<float> second = counting_from(100, 24);  // impacts at 0, 12
  const std::vector<float> window =
      splice(Waveform<float>{first, {30, 3, 4}}, Waveform<float>{second, {24, 2, 4}},
             {.start = 2, .change = 3, .turn = 1}, 6);
  // Half a period after an impact is sample 5 of the first and, one impact ahead, 6 + 12 of the
  // second.
  EXPECT_EQ(window, (std::vector<float>{2, 3, 4, 118, 119, 120}));
}

TEST(DrawPassage, DrawsFromTheWholeCycleAndWindow) {
  const Cycle cycle{30, 3, 4};
  std::vector<bool> starts(30);
  std::vector<bool> changes(8);
  std::vector<bool> turns(3);
  Stream random("passages");
  for (int i = 0; i < 1000; ++i) {
    const Passage passage = draw_passage(cycle, 8, random);
    starts.at(passage.start) = true;
    changes.at(passage.change) = true;
    turns.at(passage.turn) = true;
  }
  for (const auto& all : {starts, changes, turns}) {
    for (const bool drawn : all) EXPECT_TRUE(drawn);
  }
}

}  // namespace
}  // namespace piae::signal
