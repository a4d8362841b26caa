#pragma once

#include <optional>
#include <string>
#include <vector>

#include "signal/dataset_info.hpp"

namespace piae::signal {

/// Stiffness and damping of eq. 13. Known where a signal was simulated or a window generated.
struct DynamicParameters {
  double stiffness_n_per_m = 0;  ///< k
  double damping_ns_per_m = 0;   ///< c
};

/// One signal of one class, at the dataset's sample rate.
struct Record {
  std::string name;                    ///< unique: "IR007", "IR007-03"
  int label = 0;                       ///< index into DatasetInfo::classes
  double original_sample_rate_hz = 0;  ///< before resampling
  double shaft_speed_rpm = 0;
  std::string source;                           ///< file below DATA_DIR, or "simulated"
  std::string source_sha256;                    ///< empty when simulated
  std::vector<double> signal;                   ///< acceleration, in the unit of the source
  std::optional<DynamicParameters> parameters;  ///< the truth, where simulated
};

/// The content of records.h5 (kind "records"): /records/<name> is one dataset a record, with label,
/// rates, source and true parameters as its attributes.
struct Recordings {
  DatasetInfo info;
  std::vector<Record> records;  ///< in alphabetical order of their names
};

void write(artefact::Writer& writer, const Recordings& recordings);
/// Throws artefact::Refusal for labels that do not exist, empty signals and classes without a
/// record.
Recordings read_recordings(const artefact::Reader& reader);

}  // namespace piae::signal
