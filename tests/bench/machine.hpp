#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <ctime>
#include <vector>

#include "base/vector.hpp"

/// Limits of this core, measured in the run that is compared with them.
namespace piae::bench {

/// Returns the processor time of this process in s. Other programs on the machine have little
/// effect on it. It includes all threads of the process, of which `make bench` allows one.
inline double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Returns the number of `round` calls per second. `round` changes independent vectors, so the
/// number of the core's units is the limit.
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

/// Returns fused additions and multiplications per second.
template <class T>
double peak_flops_per_s() {
  constexpr std::size_t chains = 12;
  const auto round = [](std::array<Vector<T>, chains>& x) {
    for (Vector<T>& chain : x) chain = chain * T{0.5} + T{1};
  };
  return 2.0 * chains * lanes<T> * rounds_per_s<T, chains>(round);
}

/// Returns bytes read and written per second when an array of this size is copied.
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

/// Returns bytes read per second from an array of this size. Writing the array back costs nothing
/// more if it is larger than the core's own cache.
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
