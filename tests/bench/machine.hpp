#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <ctime>
#include <vector>

#include "base/vector.hpp"

/// What this core can do at most, measured in the run that compares itself with it.
namespace piae::bench {

/// Time that this process has computed for: other programs on the machine count little in it, but
/// all of its own threads, of which `make bench` allows one.
inline double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// How often a second this core does `round`, which changes vectors that do not depend on each
/// other: what keeps it from more is the number of its units.
template <class T, std::size_t chains, class Round>
double rounds_per_s(const Round& round) {
  constexpr int rounds = 2'000'000;
  std::array<Vector<T>, chains> x{};
  const double start = processor_seconds();
  for (int i = 0; i < rounds; ++i) round(x);
  const double taken = processor_seconds() - start;
  benchmark::DoNotOptimize(x);
  return rounds / taken;
}

/// Additions and multiplications a second, fused.
template <class T>
double peak_flops_per_s() {
  constexpr std::size_t chains = 12;
  const auto round = [](std::array<Vector<T>, chains>& x) {
    for (Vector<T>& chain : x) chain = chain * T{0.5} + T{1};
  };
  return 2.0 * chains * lanes<T> * rounds_per_s<T, chains>(round);
}

/// Bytes read and written a second where an array of this size is copied to another.
inline double copied_bytes_per_s(std::size_t size) {
  std::vector<char> from(size, 1);
  std::vector<char> to(size, 2);
  constexpr double total = 4e9;
  const int rounds = static_cast<int>(total / static_cast<double>(size)) + 1;
  std::memcpy(to.data(), from.data(), size);
  const double start = processor_seconds();
  for (int i = 0; i < rounds; ++i) {
    std::memcpy(to.data(), from.data(), size);
    benchmark::DoNotOptimize(to.data());
  }
  return 2.0 * rounds * static_cast<double>(size) / (processor_seconds() - start);
}

/// Bytes read a second from an array of this size. Writing back what was read costs nothing more
/// where the array is larger than the core's own cache.
inline double read_bytes_per_s(std::size_t size) {
  const std::vector<float> from(size / sizeof(float), 1);
  constexpr double total = 4e9;
  const int rounds = static_cast<int>(total / static_cast<double>(size)) + 1;
  constexpr std::size_t chains = 4;
  constexpr std::size_t at_once = chains * lanes<float>;
  std::array<Vector<float>, chains> sums{};
  const double start = processor_seconds();
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i + at_once <= from.size(); i += at_once) {
      for (std::size_t k = 0; k < chains; ++k) sums[k] += load(&from[i + k * lanes<float>]);
    }
    benchmark::DoNotOptimize(sums);
  }
  return static_cast<double>(rounds) * static_cast<double>(size) / (processor_seconds() - start);
}

}  // namespace piae::bench
