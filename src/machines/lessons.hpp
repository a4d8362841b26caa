#pragma once

#include <functional>
#include <vector>

#include "base/label.hpp"
#include "base/random.hpp"
#include "machines/wear.hpp"
#include "symptoms/symptoms.hpp"
#include "zero/prior.hpp"

namespace piae::machines {

/// Settings of lessons about drawn machines.
struct LessonOptions {
  int machines = 600;
  /// Windows of each machine: of the healthy reference; healthy ones of another day; those of
  /// each fault type.
  int reference = 24;
  int healthy = 10;
  int of_each_fault = 10;
  double prewhitening = 0;  ///< of spectra::order_spectrum()
  zero::Prior prior = {};
  Wear wear = {};
};

/// Symptoms of windows, each against the healthy reference of its machine.
struct Lessons {
  std::vector<symptoms::Symptoms> symptoms;
  std::vector<Label> labels;  ///< 0 healthy, then symptoms::fault_types
};

/// Simulates machines (machine.hpp) with each fault type, by the twin of piae-dt-zero and worn
/// surfaces (wear.hpp), and measures the symptoms of their windows. Machine i draws only from the
/// stream's child "<i>". Calls `machine_done` with the number of finished machines, on any thread
/// but one at a time.
Lessons draw_lessons(const LessonOptions& options, const Stream& stream,
                     const std::function<void(std::size_t)>& machine_done = {});

}  // namespace piae::machines
