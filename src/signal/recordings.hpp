#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "signal/dataset_info.hpp"

namespace piae::signal {

/// Stiffness and damping of eq. 13. They are known where a signal was simulated, and where a window
/// was generated from them.
struct DynamicParameters {
  double stiffness_n_per_m = 0;  ///< k
  double damping_ns_per_m = 0;   ///< c
};

/// A file that a record was read from.
struct SourceFile {
  std::string name;  ///< below DATA_DIR
  std::string sha256;
};

/// Gives the sha256 of the only file; of several that of what `sha256sum` prints of them: a line
/// "SHA256  NAME" each.
std::string sha256_of(const std::vector<SourceFile>& files);

/// One signal of one class, at the dataset's sample rate.
struct Record {
  std::string name;  ///< unique: "IR007", "IR007-03"
  Label label = 0;
  double original_sample_rate_hz = 0;  ///< before resampling
  double shaft_speed_rpm = 0;
  std::string source;          ///< files below DATA_DIR as they are described, or "simulated"
  std::string source_sha256;   ///< of all of them, by sha256_of(); empty when simulated
  std::vector<double> signal;  ///< acceleration, in the unit of the source
  std::optional<DynamicParameters> parameters;  ///< the truth, where simulated
  std::int32_t condition = every_condition;     ///< index into the dataset's conditions
  std::optional<double> defect_size_mm = {};    ///< its own, where its class holds several
  /// Samples of the signal from each file, in their order. No window crosses from one into the
  /// next. Empty where the signal is of one piece.
  std::vector<std::size_t> pieces = {};
  std::vector<SourceFile> files = {};  ///< not stored here: provenance names them

  /// Gives the lengths of the pieces; that of the signal where it is of one.
  [[nodiscard]] std::vector<std::size_t> piece_lengths() const;
};

/// The content of records.h5 (kind "records"). Each record is an HDF5 dataset /records/<name>, with
/// label, rates, source and, where there are any, condition, own size and true parameters as its
/// attributes. Where it is of several pieces, their lengths stand in /pieces/<name>.
struct Recordings {
  DatasetInfo info;
  std::vector<Record> records;  ///< in alphabetical order of their names

  /// Whether all of them have true parameters; whether one has a size of its own.
  [[nodiscard]] bool have_parameters() const;
  [[nodiscard]] bool have_sizes() const;
  /// The samples of all records together.
  [[nodiscard]] std::size_t samples() const;
};

/// Writes recordings one by one, so that one at a time needs to be in memory.
class RecordingsWriter {
 public:
  /// `writer` and `info` must outlive it.
  RecordingsWriter(artefact::Writer& writer, const DatasetInfo& info);
  void add(const Record& record);
  /// Writes what stands behind all records.
  void finish();

 private:
  artefact::Writer& writer_;
  const DatasetInfo& info_;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> pieces_;  ///< of several, by name
};

void write(artefact::Writer& writer, const Recordings& recordings);
/// Throws artefact::Refusal for labels that no class has, for conditions that the dataset does not
/// name, for empty signals, and for classes without a record.
Recordings read_recordings(const artefact::Reader& reader);

}  // namespace piae::signal
