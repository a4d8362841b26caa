#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "signal/dataset_info.hpp"
#include "signal/speed_source.hpp"
#include "signal/toml_table.hpp"

namespace piae::signal {

/// One raw recording as the description declares it.
struct RecordSource {
  /// Class and condition, "IR2-900-rpm"; numbered if several records share them: "IR007-02".
  std::string name;
  Label label = 0;
  /// Files below DATA_DIR: names, or patterns that match many (record_files.hpp). Each file is one
  /// stretch of the recording. A window does not cross from one file into the next.
  std::vector<std::string> files;
  std::string variable;  ///< of a .mat; column of a .csv or .txt; dataset of an .h5
  double sample_rate_hz = 0;
  double shaft_speed_rpm = 0;
  std::string sha256;          ///< 64 hexadecimal digits (sha256_of()); empty: not checked
  std::string url;             ///< download address; empty if there is none
  std::string condition = {};  ///< empty: belongs to every condition
  std::optional<double> defect_size_mm = {};  ///< its own, if sizes differ within the class
  /// Acceleration of one unit of the files; if empty, the data set's.
  std::optional<double> unit_m_per_s2 = {};
  double offset = 0;  ///< the files' value at zero acceleration
  /// Time between the starts of two successive files, if they are snapshots of a longer run.
  std::optional<double> snapshot_interval_s = {};
  /// Source of its speed over time. `shaft_speed_rpm` is then the data set's until the files are
  /// read (measured_speed.hpp).
  std::optional<SpeedSource> speed = {};

  /// Returns the names and patterns in one line.
  [[nodiscard]] std::string file_text() const;
  /// Returns the file of tachometer pulses, if there is one.
  [[nodiscard]] std::optional<std::string> tacho_file() const;
};

/// Settings of the stage split by their names, such as "windows-per-class".
using SplitSettings = std::map<std::string, std::size_t>;

/// A data set description (pipeline/datasets/<name>.toml):
///
///     name = "cwru"
///     sample_rate_hz = 12000      # resampling rate; without it all records must agree
///     shaft_speed_rpm = 1797
///     speed_search_percent = 10   # optional: takes speeds from the signals, within this range
///     unit_m_per_s2 = 9.80665     # one unit of the signals, here g; without it m/s^2
///     [bearing]                   # all keys of bearing::Geometry; default raceways: the
///                                 # pitch diameter minus and plus the ball's. Not
///                                 # needed if all faults are `other`
///     [[class]]                   # labels in this order
///     name = "IR007"
///     defect = "inner"            # none (exactly one class), outer, inner, roller or other
///     defect_size_mm = 0.1778     # optional, along the raceway; not for "none" and "other"
///     [[record]]                  # one or more for each class
///     class = "IR007"
///     file = "cwru/105.mat"       # or a list of files, or a pattern: "run/acc_*.csv"
///     variable = "X105_DE_time"
///     sample_rate_hz = 12000
///     shaft_speed_rpm = 1797      # optional, default: the data set's; or where its speed over
///                                 # time is (speed_source.hpp)
///     condition = "0 HP"          # optional: the state of the machine, in any words
///     defect_size_mm = 0.1778     # optional, default: the class's, which may be
///                                 # missing if each record has its own
///     unit_m_per_s2 = 0.01        # optional, default: the data set's; with
///     offset = 2048               # the value at zero acceleration, as in counts
///     snapshot_interval_s = 10    # optional: the files start at this distance, for monitor
///     sha256 = "..."              # optional
///     url = "https://..."         # optional
///     [transfer]                  # optional: faults known in one condition, tested in another
///                                 # (described_conditions.hpp)
///     [split]                     # optional: settings of the stage split for this data set alone,
///     known-per-class = 5         # replacing those of the protocol
///
/// or windows-per-class = 300, test-per-class = 50 for short recordings. (All of
/// split_settings() are allowed.) A description may be `like` another (description_file.hpp).
struct Description {
  DatasetInfo info;
  SplitSettings split = {};  ///< settings for the stage split
  /// Range about the given speeds in which they are taken from the signals (estimated_speeds.hpp);
  /// 0: the given speeds count.
  double speed_search_percent = 0;
  std::vector<RecordSource> records;  ///< in alphabetical order of their names
  /// Place of the table of bearings (bearing_table.hpp); it may be missing.
  std::filesystem::path bearing_table = {};
};

/// Reads a description. Throws Error(bad_input) with the file, line and key for unknown or missing
/// keys, wrong types, duplicate names, unknown classes, classes without a record, impossible
/// conditions, and different rates without a sample_rate_hz of the data set. Throws
/// Error(input_missing) if the file is missing.
Description read_description(const std::filesystem::path& file);

/// Returns the existing files of all records, and their files of tachometer pulses, relative to
/// `folder`.
std::vector<std::string> recordings_of(const Description& description,
                                       const std::filesystem::path& folder);

/// Lists the raw files of a description, one line "SHA256  FILE  URL" each, with "-" for missing
/// entries. Lists matching files in `folder`, and the names of missing files. Empty for a simulated
/// data set.
std::string list_of_sources(const std::filesystem::path& description,
                            const std::filesystem::path& folder);

/// Reads the part common to all descriptions: name, shaft_speed_rpm, unit_m_per_s2, [bearing] and
/// the given [[class]] tables. Classes without defect_size_mm get 0. The caller then reads
/// sample_rate_hz and other keys, and calls require_possible() and finish() of `root` and
/// `classes`.
DatasetInfo read_info(TomlTable& root, std::vector<TomlTable>& classes);

/// Refuses an impossible geometry or defect, and a defect of a bearing that is not described.
void require_possible(const DatasetInfo& info, const TomlTable& root,
                      const std::vector<TomlTable>& classes);

/// Refuses a class with defect `other` or an unknown size. Such a fault can be recorded, but not
/// simulated.
void require_simulable(const DatasetInfo& info, const std::vector<TomlTable>& classes);

}  // namespace piae::signal
