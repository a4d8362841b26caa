#include "signal/stream_resampler.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "signal/resample.hpp"

namespace piae::signal {
namespace {

std::vector<double> resampled_in_pieces(const std::vector<double>& signal, double from_hz,
                                        double to_hz, std::size_t piece) {
  StreamResampler resampler(from_hz, to_hz);
  std::vector<double> out;
  for (std::size_t at = 0; at < signal.size(); at += piece) {
    resampler.add(std::span(signal).subspan(at, std::min(piece, signal.size() - at)), out);
  }
  resampler.finish(out);
  return out;
}

TEST(StreamResampler, GivesWhatTheWholeSignalWould) {
  Stream random("resampler");
  std::vector<double> signal(20000);
  for (double& x : signal) x = random.normal(0, 1);
  for (const double from_hz : {12000.0, 25600.0, 51200.0}) {
    const auto whole = resample(signal, from_hz, 12000);
    for (const std::size_t piece : {1, 333, 4096, 100000}) {
      const auto out = resampled_in_pieces(signal, from_hz, 12000, piece);
      ASSERT_GE(out.size(), whole.size());
      ASSERT_LE(out.size(), whole.size() + 1);
      for (std::size_t i = 0; i < whole.size(); ++i) {
        ASSERT_NEAR(out[i], whole[i], 1e-9) << from_hz << ' ' << piece << ' ' << i;
      }
    }
  }
}

TEST(StreamResampler, NothingInNothingOut) {
  std::vector<double> out;
  StreamResampler resampler(48000, 12000);
  resampler.add({}, out);
  EXPECT_TRUE(out.empty());
  resampler.add(std::vector<double>{1, 2}, out);
  resampler.add({}, out);
  resampler.add(std::vector<double>(20000, 1.0), out);
  EXPECT_GT(out.size(), 4000U);
}

}  // namespace
}  // namespace piae::signal
