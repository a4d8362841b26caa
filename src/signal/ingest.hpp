#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "raw/signal.hpp"
#include "signal/description.hpp"
#include "signal/recordings.hpp"

namespace piae::signal {

/// Samples of a record as its files hold them.
struct RawRecord {
  std::vector<double> samples;     ///< of all files, concatenated
  std::vector<raw::Piece> pieces;  ///< of each file
  std::vector<SourceFile> files;
};

/// Reads the raw files of a data set below `data_dir` one by one, checks them, and resamples each
/// record to the data set's rate. Converts samples to the data set's unit.
class RecordReader {
 public:
  RecordReader(const Description& description, std::filesystem::path data_dir);

  /// Reads, checks and resamples a record. Throws Error(input_missing) for a missing file. Throws
  /// Error(bad_input), with the file and the record, for
  ///   - a file that cannot be read (raw/file.hpp), or whose sha256 is not the declared one,
  ///   - a signal that is empty, has a NaN or infinite sample (with its index), or never changes,
  ///   - the same samples as an earlier record, under any label,
  ///   - a speed over time that cannot be used (measured_speed.hpp).
  Record read(const RecordSource& source) { return resampled(source, read_raw(source)); }

  /// The two halves of read(), so that callers can examine the samples before resampling.
  /// read_raw() checks the files and remembers the samples, so a second call for the same record
  /// throws. resampled() converts to the rate and the unit of the data set.
  RawRecord read_raw(const RecordSource& source);
  [[nodiscard]] Record resampled(const RecordSource& source, RawRecord raw) const;

 private:
  [[nodiscard]] std::vector<std::string> require_files(const RecordSource& source) const;
  void require_new(const RecordSource& source, std::span<const double> signal);
  void resample_pieces(const RecordSource& source, const RawRecord& raw, Record& record) const;
  void add_speeds(const SpeedSource& source, Record& record) const;

  DatasetInfo info_;
  std::filesystem::path data_dir_;
  std::map<std::string, RecordSource> read_before_;  // by the sha256 of the samples
};

/// Callback, called with the number of finished records after each record.
using RecordsDone = std::function<void(std::size_t)>;

/// Reads all records of a data set and passes them on one by one, because together they may exceed
/// the memory. Throws RecordReader's error at the first unreadable record.
void ingest(const Description& description, const std::filesystem::path& data_dir,
            const std::function<void(const Record&)>& take);

}  // namespace piae::signal
