#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "signal/dataset_info.hpp"

namespace piae::signal {

/// Stiffness and damping of eq. 13. They are known where a signal was simulated, and where a window
/// was generated from them.
struct DynamicParameters {
  double stiffness_n_per_m = 0;  ///< k
  double damping_ns_per_m = 0;   ///< c
};

/// One signal of one class, at the dataset's sample rate.
struct Record {
  std::string name;  ///< unique: "IR007", "IR007-03"
  Label label = 0;
  double original_sample_rate_hz = 0;  ///< before resampling
  double shaft_speed_rpm = 0;
  std::string source;                           ///< file below DATA_DIR, or "simulated"
  std::string source_sha256;                    ///< empty when simulated
  std::vector<double> signal;                   ///< acceleration, in the unit of the source
  std::optional<DynamicParameters> parameters;  ///< the truth, where simulated
  std::int32_t condition = every_condition;     ///< index into the dataset's conditions
  std::optional<double> defect_size_mm = {};    ///< its own, where its class holds several
};

/// The content of records.h5 (kind "records"). Each record is an HDF5 dataset /records/<name>, with
/// label, rates, source and, where there are any, condition, own size and true parameters as its
/// attributes.
struct Recordings {
  DatasetInfo info;
  std::vector<Record> records;  ///< in alphabetical order of their names

  /// Whether all of them have true parameters; whether one has a size of its own.
  [[nodiscard]] bool have_parameters() const;
  [[nodiscard]] bool have_sizes() const;
};

void write(artefact::Writer& writer, const Recordings& recordings);
/// Throws artefact::Refusal for labels that no class has, for conditions that the dataset does not
/// name, for empty signals, and for classes without a record.
Recordings read_recordings(const artefact::Reader& reader);

}  // namespace piae::signal
