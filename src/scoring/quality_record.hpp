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

/// The content of score.h5 (kind "score"): how good the generated windows of one method are.
struct QualityRecord {
  signal::DatasetInfo info;
  std::string method;  ///< which generated the windows
  std::int64_t seed = 0;
  signal::Protocol protocol = signal::Protocol::random;  ///< of the split
  std::vector<ClassQuality> classes;                     ///< [K], by label

  /// Of the fault line over the classes that have one; 0 where none has.
  [[nodiscard]] double mean_over_classes(const Metric& metric) const;
};

/// In the artefact: attributes of the root, those of DatasetInfo and `method`, `seed` and
/// `protocol`; datasets /labels int32 [K], /windows_compared int64 [K], and /quality/<metric>
/// float64 [K].
void write(artefact::Writer& writer, const QualityRecord& record);
/// Throws artefact::Refusal for labels that no class has or that come twice, and for shapes that do
/// not fit each other.
QualityRecord read_quality(const artefact::Reader& reader);

}  // namespace piae::scoring
