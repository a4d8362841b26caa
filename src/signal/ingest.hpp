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

/// The samples of a record as they stand in its files.
struct RawRecord {
  std::vector<double> samples;     ///< of all files, one behind the other
  std::vector<raw::Piece> pieces;  ///< of each file
  std::vector<SourceFile> files;
};

/// Reads the raw files of a dataset below `data_dir` one by one, checks them, and brings each
/// record to the dataset's sample rate. Samples keep the unit of their source.
class RecordReader {
 public:
  RecordReader(const Description& description, std::filesystem::path data_dir);

  /// Throws Error(input_missing) for a file that is not there, and Error(bad_input), with the file
  /// and the record, for
  ///   - a file whose sha256 is not the declared one, or that cannot be read (raw/file.hpp),
  ///   - a signal that is empty, has a NaN or infinite sample (with its index), or never changes,
  ///   - the same samples as a record that was read before, under one label or two.
  Record read(const RecordSource& source) { return resampled(source, read_raw(source)); }

  /// The two halves of read(), which allow a look at the samples before they are resampled.
  RawRecord read_raw(const RecordSource& source);
  [[nodiscard]] Record resampled(const RecordSource& source, RawRecord raw) const;

 private:
  [[nodiscard]] std::vector<std::string> require_files(const RecordSource& source) const;
  void require_new(const RecordSource& source, std::span<const double> signal);
  void resample_pieces(const RecordSource& source, const RawRecord& raw, Record& record) const;

  DatasetInfo info_;
  std::filesystem::path data_dir_;
  std::map<std::string, RecordSource> read_before_;  // by the sha256 of the samples
};

/// Called after each record that was read, with how many are done.
using RecordsDone = std::function<void(std::size_t)>;

/// Reads all records of a dataset and passes them on one by one: together they may be larger than
/// the memory. Throws RecordReader's error at the first that cannot be read.
void ingest(const Description& description, const std::filesystem::path& data_dir,
            const std::function<void(const Record&)>& take);

}  // namespace piae::signal
