#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "scoring/accuracy.hpp"
#include "signal/dataset_info.hpp"

namespace piae::scoring {

/// Share of a number of windows.
struct Share {
  std::int64_t count = 0;
  std::int64_t of = 0;  ///< 0 without such windows
  /// Returns the share in percent; there must be at least one window.
  [[nodiscard]] double percent() const;
};

/// Returns the share of a class's windows that were recognised.
Share recall_of(const Confusion& confusion, std::size_t truth);

/// Return the share of faulty windows predicted as healthy, and of healthy windows predicted as
/// faulty. `classes` are those of the confusion matrix.
Share missed_faults(const Confusion& confusion, std::span<const signal::ClassInfo> classes);
Share false_alarms(const Confusion& confusion, std::span<const signal::ClassInfo> classes);

}  // namespace piae::scoring
