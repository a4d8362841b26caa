#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "signal/dataset_info.hpp"
#include "signal/toml_table.hpp"

namespace piae::signal {

/// One raw recording as the description declares it.
struct RecordSource {
  /// That of its class and its condition, "IR2-900-rpm", numbered where there are several of these:
  /// "IR007-02".
  std::string name;
  Label label = 0;
  /// Below DATA_DIR: names, or patterns that stand for many (record_files.hpp). Of several files
  /// each is a stretch of the recording, and no window crosses from one into the next.
  std::vector<std::string> files;
  std::string variable;  ///< of a .mat; column of a .csv or .txt; dataset of an .h5
  double sample_rate_hz = 0;
  double shaft_speed_rpm = 0;
  std::string sha256;  ///< 64 hexadecimal digits (sha256_of()); empty where it is not checked
  std::string url;     ///< where the file can be downloaded; empty where it cannot
  std::string condition = {};                 ///< empty where it belongs to every one
  std::optional<double> defect_size_mm = {};  ///< its own, where the class holds several
  /// Acceleration of one unit of the files; the dataset's where it has none of its own.
  std::optional<double> unit_m_per_s2 = {};
  double offset = 0;  ///< the files' number for no acceleration

  /// Gives the names and patterns in one line.
  [[nodiscard]] std::string file_text() const;
};

/// Settings of the stage split by their names, such as "windows-per-class".
using SplitSettings = std::map<std::string, std::size_t>;

/// A dataset description (pipeline/datasets/<name>.toml):
///
///     name = "cwru"
///     sample_rate_hz = 12000      # all records are resampled to it; without it they must agree
///     shaft_speed_rpm = 1797
///     unit_m_per_s2 = 9.80665     # one unit of the signals, here g; without it m/s^2
///     [bearing]                   # all keys of bearing::Geometry; without the raceways these
///                                 # are the pitch diameter minus and plus the ball's. Not
///                                 # needed where all faults are `other`
///     [[class]]                   # labels in this order
///     name = "IR007"
///     defect = "inner"            # none (exactly one class), outer, inner, roller or other
///     defect_size_mm = 0.1778     # optional, along the raceway; not for "none" and "other"
///     [[record]]                  # one or more for each class
///     class = "IR007"
///     file = "cwru/105.mat"       # or a list of files, or a pattern: "run/acc_*.csv"
///     variable = "X105_DE_time"
///     sample_rate_hz = 12000
///     shaft_speed_rpm = 1797      # optional, the dataset's otherwise
///     condition = "0 HP"          # optional: the state of the machine, in any words
///     defect_size_mm = 0.1778     # optional, the class's otherwise; a class of whose records each
///                                 # has its own needs none
///     unit_m_per_s2 = 0.01        # optional, the dataset's otherwise; with
///     offset = 2048               # the number that stands for no acceleration, as in counts
///     sha256 = "..."              # optional
///     url = "https://..."         # optional
///     [transfer]                  # optional: faults known in one condition, tested in another
///                                 # (described_conditions.hpp)
///     [split]                     # optional: settings of the stage split for this dataset alone,
///     known-per-class = 5         # in the place of those of the protocol
///
/// or windows-per-class = 300, test-per-class = 50 where the recordings are short. (All of
/// split_settings() may stand there.) It may be `like` another one (description_file.hpp).
struct Description {
  DatasetInfo info;
  SplitSettings split = {};           ///< what it sets for the stage split
  std::vector<RecordSource> records;  ///< in alphabetical order of their names
};

/// Throws Error(bad_input) with the file, line and key for unknown or missing keys, wrong types,
/// names twice, unknown classes, classes without a record, rates that differ without a
/// sample_rate_hz of the dataset, and conditions that cannot be; Error(input_missing) when there is
/// no such file.
Description read_description(const std::filesystem::path& file);

/// Lists the raw files of a description, a line "SHA256  FILE  URL" each, with "-" for what it does
/// not say: those in `folder`, and what it names beyond them. Empty for a data set that is
/// simulated.
std::string list_of_sources(const std::filesystem::path& description,
                            const std::filesystem::path& folder);

/// Reads the part that every description has: name, shaft_speed_rpm, unit_m_per_s2, [bearing] and
/// the given [[class]] tables, of which those without a defect_size_mm get 0. The caller reads
/// sample_rate_hz and whatever else there may be, and then calls require_possible(), and finish()
/// of `root` and `classes`.
DatasetInfo read_info(TomlTable& root, std::vector<TomlTable>& classes);

/// Refuses a geometry or a defect that no bearing can have, and one of a bearing that is not
/// described.
void require_possible(const DatasetInfo& info, const TomlTable& root,
                      const std::vector<TomlTable>& classes);

/// Refuses a class of which nothing says how it moves, and one whose size nobody knows: such a
/// fault can be recorded, but not simulated.
void require_simulable(const DatasetInfo& info, const std::vector<TomlTable>& classes);

}  // namespace piae::signal
