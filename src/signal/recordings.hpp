#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "signal/dataset_info.hpp"
#include "signal/speed_course.hpp"

namespace piae::signal {

/// Stiffness and damping of eq. 13: true values of simulated signals, or values that a method
/// infers, fits or draws.
struct DynamicParameters {
  double stiffness_n_per_m = 0;  ///< k
  double damping_ns_per_m = 0;   ///< c
};

/// A file that a record was read from.
struct SourceFile {
  std::string name;  ///< below DATA_DIR
  std::string sha256;
};

/// Returns the sha256 of a single file. For several files, returns the sha256 of the output of
/// `sha256sum`: one line "SHA256  NAME" each.
std::string sha256_of(const std::vector<SourceFile>& files);

/// One signal of one class, at the data set's sample rate.
struct Record {
  std::string name;  ///< unique: "IR007", "IR007-03"
  Label label = 0;
  double original_sample_rate_hz = 0;  ///< before resampling
  double shaft_speed_rpm = 0;
  std::string source;          ///< files below DATA_DIR, as described, or "simulated"
  std::string source_sha256;   ///< of all files, by sha256_of(); empty if simulated
  std::vector<double> signal;  ///< acceleration, in the data set's unit
  std::optional<DynamicParameters> parameters;  ///< true values, if simulated
  std::int32_t condition = every_condition;     ///< index into the data set's conditions
  std::optional<double> defect_size_mm = {};    ///< its own, if sizes differ within the class
  /// Samples of the signal from each file, in order. A window does not cross from one piece into
  /// the next. Empty for a signal in one piece.
  std::vector<std::size_t> pieces = {};
  /// Time between the starts of two successive pieces, if they are snapshots of a longer run.
  std::optional<double> snapshot_interval_s = {};
  /// Speed over time, if it was recorded; `shaft_speed_rpm` is then its mean.
  std::optional<SpeedCourse> speeds = {};
  std::vector<SourceFile> files = {};  ///< not stored here: provenance names them

  /// Returns the lengths of the pieces; the signal's for a signal in one piece.
  [[nodiscard]] std::vector<std::size_t> piece_lengths() const;
  /// Returns the mean speed over `count` samples from `first` on, at the data set's rate.
  [[nodiscard]] double speed_rpm(std::size_t first, std::size_t count, double rate_hz) const;
};

/// The content of records.h5 (kind "records"). Each record is an HDF5 dataset /records/<name>. Its
/// attributes are label, rates, source and, if known, condition, own size, interval of snapshots
/// and true parameters. /pieces/<name> holds the lengths of the pieces if there are several.
/// /speeds/<name> float64 [blocks] in rpm, with the attribute block_s, holds the speed over time if
/// it was recorded.
struct Recordings {
  DatasetInfo info;
  std::vector<Record> records;  ///< in alphabetical order of their names

  /// True if all records have true parameters; true if any record has its own size.
  [[nodiscard]] bool have_parameters() const;
  [[nodiscard]] bool have_sizes() const;
  /// True if the speed of a record was recorded over its time, or differs from the data set's by
  /// more than 1 %.
  [[nodiscard]] bool have_speeds() const;
  /// Returns the samples of all records together.
  [[nodiscard]] std::size_t samples() const;
};

/// Writes recordings one by one, so that only one needs to be in memory.
class RecordingsWriter {
 public:
  /// Writes `info` and the group of the records. Keeps references: `writer` and `info` must outlive
  /// it.
  RecordingsWriter(artefact::Writer& writer, const DatasetInfo& info);
  void add(const Record& record);
  /// Writes /pieces and /speeds, after the last record.
  void finish();

  /// Returns the samples of all records so far.
  [[nodiscard]] std::size_t samples() const { return samples_; }

 private:
  artefact::Writer& writer_;
  const DatasetInfo& info_;
  std::size_t samples_ = 0;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> pieces_;  ///< of several, by name
  std::vector<std::pair<std::string, SpeedCourse>> speeds_;               ///< by name
};

void write(artefact::Writer& writer, const Recordings& recordings);
/// Reads recordings. Throws artefact::Refusal for labels without a class, unknown conditions, empty
/// signals, and classes without a record.
Recordings read_recordings(const artefact::Reader& reader);

}  // namespace piae::signal
