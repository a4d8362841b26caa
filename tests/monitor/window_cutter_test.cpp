#include "monitor/window_cutter.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <string>
#include <vector>

namespace piae::monitor {
namespace {

/// Returns "first sample:first-last value" of each window, where sample i has the value i.
std::string windows_of(std::size_t length, std::size_t stride, std::size_t samples,
                       std::size_t piece) {
  WindowCutter cutter(length, stride);
  std::vector<double> signal(samples);
  std::iota(signal.begin(), signal.end(), 0);
  std::string text;
  for (std::size_t at = 0; at < samples; at += piece) {
    cutter.add(std::span(signal).subspan(at, std::min(piece, samples - at)));
    while (const auto window = cutter.next()) {
      EXPECT_EQ(window->samples.size(), length);
      text += std::to_string(window->first_sample) + ":" +
              std::to_string(static_cast<int>(window->samples.front())) + "-" +
              std::to_string(static_cast<int>(window->samples.back())) + " ";
    }
  }
  return text;
}

TEST(WindowCutter, CutsWindowsInAnyPieces) {
  for (const std::size_t piece : {1, 2, 3, 4, 5, 7, 14, 100}) {
    EXPECT_EQ(windows_of(4, 4, 14, piece), "0:0-3 4:4-7 8:8-11 ") << piece;
  }
}

TEST(WindowCutter, MayOverlapOrSkipSamples) {
  for (const std::size_t piece : {1, 3, 8, 100}) {
    EXPECT_EQ(windows_of(4, 2, 9, piece), "0:0-3 2:2-5 4:4-7 ") << piece;
    EXPECT_EQ(windows_of(3, 10, 24, piece), "0:0-2 10:10-12 20:20-22 ") << piece;
  }
}

TEST(WindowCutter, CutsNoWindowAcrossARestart) {
  WindowCutter cutter(3, 3);
  cutter.add(std::vector<double>{1, 2});
  EXPECT_EQ(cutter.waiting(), 2U);
  cutter.restart();
  EXPECT_EQ(cutter.waiting(), 0U);
  cutter.add(std::vector<double>{7, 8, 9});
  const auto window = cutter.next();
  ASSERT_TRUE(window.has_value());
  EXPECT_EQ(window->first_sample, 0U);
  EXPECT_EQ(window->samples.front(), 7);
}

}  // namespace
}  // namespace piae::monitor
