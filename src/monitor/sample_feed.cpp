#include "monitor/sample_feed.hpp"

#include <algorithm>
#include <cmath>

namespace piae::monitor {

namespace {

/// Larger samples count as not finite. Windows are 32-bit floats, up to 3e38, and resampling may
/// exceed the samples of the stream.
constexpr double largest_sample = 1e36;

bool is_sample(double x) { return std::abs(x) <= largest_sample; }

}  // namespace

void SampleFeed::add(std::span<const std::byte> bytes, const Take& take, const Gap& gap) {
  decoded_.clear();
  decoder_.add(bytes, decoded_);
  pass_on(decoded_, take, gap);
}

void SampleFeed::finish(const Take& take, const Gap& gap) {
  decoded_.clear();
  decoder_.finish(decoded_);
  pass_on(decoded_, take, gap);
}

void SampleFeed::pass_on(std::span<const double> samples, const Take& take, const Gap& gap) {
  while (!samples.empty()) {
    const auto first_bad = std::ranges::find_if_not(samples, is_sample);
    const auto good = static_cast<std::size_t>(first_bad - samples.begin());
    samples_ += good;
    take(samples.first(good));
    samples = samples.subspan(good);
    if (samples.empty()) return;
    const auto next_good = std::ranges::find_if(samples, is_sample);
    const auto bad = static_cast<std::size_t>(next_good - samples.begin());
    samples_ += bad;
    not_finite_ += bad;
    samples = samples.subspan(bad);
    gap();
  }
}

}  // namespace piae::monitor
