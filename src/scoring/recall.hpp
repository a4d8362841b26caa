#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "scoring/accuracy.hpp"
#include "signal/dataset_info.hpp"

namespace piae::scoring {

/// What share of a number of windows something happened to.
struct Share {
  std::int64_t count = 0;
  std::int64_t of = 0;  ///< 0 where there was no such window
  /// Of a share of at least one window.
  [[nodiscard]] double percent() const;
};

/// Of the windows of a class those that were recognised.
Share recall_of(const Confusion& confusion, std::size_t truth);

/// Of the windows with a fault those that were taken for healthy ones, and of the healthy ones
/// those that were taken for faulty. `classes` are those of the confusion matrix.
Share missed_faults(const Confusion& confusion, std::span<const signal::ClassInfo> classes);
Share false_alarms(const Confusion& confusion, std::span<const signal::ClassInfo> classes);

}  // namespace piae::scoring
