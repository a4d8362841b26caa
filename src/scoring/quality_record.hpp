#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "scoring/quality.hpp"
#include "signal/dataset_info.hpp"
#include "signal/protocol.hpp"

namespace piae::scoring {

/// The content of score.h5 (kind "score"): the quality of the windows of one method.
struct QualityRecord {
  signal::DatasetInfo info;
  std::string method;  ///< method that generated the windows
  std::int64_t seed = 0;
  signal::Protocol protocol = signal::Protocol::random;  ///< of the split
  std::vector<ClassQuality> classes;                     ///< [K], by label

  /// Returns the mean of a metric. Metrics of the fault line use only classes that have one; 0 if
  /// none has.
  [[nodiscard]] double mean_over_classes(const Metric& metric) const;
};

/// Writes the root attributes of DatasetInfo and `method`, `seed` and `protocol`; the datasets
/// /labels int32 [K], /windows_compared int64 [K], and /quality/<metric> float64 [K].
void write(artefact::Writer& writer, const QualityRecord& record);
/// Throws artefact::Refusal for labels without a class, for repeated labels, and for shapes that do
/// not match.
QualityRecord read_quality(const artefact::Reader& reader);

}  // namespace piae::scoring
