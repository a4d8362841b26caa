#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "scoring/quality.hpp"
#include "signal/dataset_info.hpp"

namespace piae::scoring {

/// The content of score.h5 (kind "score").
struct QualityRecord {
  signal::DatasetInfo info;
  std::string method;  ///< that generated the windows
  std::int64_t seed = 0;
  std::string protocol;               ///< of the split: "random", "blocked"
  std::vector<ClassQuality> classes;  ///< K of them, in the order of their labels
};

/// In the artefact: attributes of the root, those of DatasetInfo and `method`, `seed` and
/// `protocol`; datasets /labels int32 [K], /windows_compared int64 [K], and /quality/<metric>
/// float64 [K].
void write(artefact::Writer& writer, const QualityRecord& record);
/// Throws artefact::Refusal for labels that do not exist or come twice, and shapes that do not fit.
QualityRecord read_quality(const artefact::Reader& reader);

}  // namespace piae::scoring
