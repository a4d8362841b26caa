#include "inspection/repeats.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_map>

namespace piae::inspection {

namespace {

constexpr std::size_t block = 32;  // each stretch of 2 * block samples contains a whole block
constexpr std::size_t shortest_repeat = 2 * block;
constexpr std::size_t fewest_turns_in_a_repeat = 32;

/// Hash of the last `block` samples, a polynomial in an odd base modulo 2^64.
class RollingHash {
 public:
  void add(double sample) { hash_ = hash_ * base + mixed(sample); }
  void remove_oldest(double sample) { hash_ -= leading * mixed(sample); }
  void clear() { hash_ = 0; }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  static constexpr std::uint64_t base = 0x9E3779B97F4A7C15U;
  static constexpr std::uint64_t leading = [] {
    std::uint64_t power = 1;
    for (std::size_t i = 1; i < block; ++i) power *= base;
    return power;
  }();
  static std::uint64_t mixed(double sample) {
    auto bits = std::bit_cast<std::uint64_t>(sample + 0.0);  // -0 equals 0
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
    return bits ^ (bits >> 31U);
  }

  std::uint64_t hash_ = 0;
};

/// Returns how often the signal changes between rising and falling.
std::size_t turns_of(std::span<const double> samples) {
  std::size_t turns = 0;
  int direction = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const int now = (samples[i] > samples[i - 1]) - (samples[i] < samples[i - 1]);
    if (now == 0) continue;
    if (direction != 0 && now != direction) ++turns;
    direction = now;
  }
  return turns;
}

/// Searches a record in one pass: compares each place with earlier blocks.
class Search {
 public:
  explicit Search(std::span<const double> samples) : samples_(samples) {}

  Repeats run() {
    std::size_t at = 0;
    while (at + block <= samples_.size()) {
      at = enter(at);
      while (at + block <= samples_.size() && !match_at(at)) at = step(at);
      if (at + block <= samples_.size()) at = end_of_match_ - block + 1;
    }
    return found_;
  }

 private:
  /// Hashes the block that starts here.
  std::size_t enter(std::size_t at) {
    hash_.clear();
    for (std::size_t i = at; i < at + block; ++i) hash_.add(samples_[i]);
    return at;
  }
  std::size_t step(std::size_t at) {
    hash_.remove_oldest(samples_[at]);
    if (at + block < samples_.size()) hash_.add(samples_[at + block]);
    return at + 1;
  }

  /// Looks for an earlier block equal to the one that starts here, and stores this one for later.
  bool match_at(std::size_t at) {
    const auto known = blocks_.find(hash_.value());
    if (known == blocks_.end()) {
      if (at >= next_kept_) {
        blocks_.emplace(hash_.value(), at);
        next_kept_ = at + block;
      }
      return false;
    }
    if (!std::equal(samples_.begin() + offset(at), samples_.begin() + offset(at + block),
                    samples_.begin() + offset(known->second))) {
      return false;
    }
    measure(known->second, at);
    return true;
  }

  /// Extends a match of two blocks as far as both stretches agree.
  void measure(std::size_t original, std::size_t first) {
    std::size_t end = first + block;
    while (end < samples_.size() && samples_[end] == samples_[end - first + original]) ++end;
    while (original > 0 && first > end_of_match_ && samples_[first - 1] == samples_[original - 1]) {
      --first;
      --original;
    }
    end_of_match_ = end;
    next_kept_ = std::max(next_kept_, end - block + 1);
    const std::size_t length = end - first;
    if (length < shortest_repeat) return;
    if (turns_of(samples_.subspan(first, length)) < fewest_turns_in_a_repeat) return;
    ++found_.count;
    found_.samples += length;
    if (length <= found_.longest) return;
    found_.longest = length;
    found_.first = first;
    found_.original = original;
  }

  static std::ptrdiff_t offset(std::size_t at) { return static_cast<std::ptrdiff_t>(at); }

  std::span<const double> samples_;
  RollingHash hash_;
  std::unordered_map<std::uint64_t, std::size_t> blocks_;
  std::size_t next_kept_ = 0;     ///< next place whose block is stored
  std::size_t end_of_match_ = 0;  ///< of the last match
  Repeats found_;
};

}  // namespace

Repeats repeats(std::span<const double> samples) { return Search(samples).run(); }

}  // namespace piae::inspection
