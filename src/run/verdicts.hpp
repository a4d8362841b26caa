#pragma once

#include <cstdint>
#include <vector>

#include "artefact/reader.hpp"
#include "classification/record.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"
#include "signal/dataset_info.hpp"
#include "signal/protocol.hpp"

namespace piae::run {

/// Verdicts of a kept classifier on the records of its data set.
struct Verdicts {
  signal::DatasetInfo info = {};
  signal::Protocol protocol = signal::Protocol::random;  ///< of the classifier's split
  std::vector<classification::Named> records = {};

  /// True if the record has a fault.
  [[nodiscard]] bool is_faulty(const classification::Named& record) const;
  /// Returns the number of faulty records whose fault is named.
  [[nodiscard]] std::size_t count_right_faults() const;
};

/// Reads classification.h5 of a cell. Throws artefact::Refusal if another classifier than the one
/// kept in the cell made it.
Verdicts read_verdicts(const Layout& layout, const Combination& cell, std::int64_t seed);

}  // namespace piae::run
