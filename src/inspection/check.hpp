#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "inspection/fault_lines.hpp"
#include "inspection/level.hpp"
#include "inspection/lone_samples.hpp"
#include "inspection/raw_flaws.hpp"
#include "inspection/repeats.hpp"
#include "inspection/unknown_bearing.hpp"
#include "inspection/value_counts.hpp"
#include "signal/description.hpp"
#include "signal/ingest.hpp"
#include "spectra/shaft_speed.hpp"

namespace piae::inspection {

/// Longest plausible run at a steady speed, in s. Longer records are not resampled, because a rate
/// in kHz would make them a thousand times too long.
inline constexpr double longest_record_s = 3600;

/// Fewest turns of the shaft in one piece that show an impact rate.
inline constexpr double fewest_turns = 10;

/// Length of the signal in the picture, in s.
inline constexpr double shown_s = 0.2;

/// One file of a record.
struct FileCheck {
  std::string name;
  std::size_t samples = 0;  ///< before resampling
  std::size_t columns = 0;  ///< of a text file; else 0
  raw::Times times = {};    ///< of a text file
  bool may_be_cut = false;  ///< true if its last number may have lost digits
};

/// Results for one record. An unreadable record has a problem and no numbers.
struct RecordCheck {
  signal::RecordSource source;   ///< with the mean speed, if the speed over time was recorded
  std::size_t file_samples = 0;  ///< before resampling
  /// Samples of each file at the data set's sample rate.
  std::vector<std::size_t> pieces;
  std::vector<FileCheck> files;  ///< in the order of their samples
  bool goes_one_way = false;
  Stretches clipped;
  Stretches held;
  std::optional<std::size_t> few_values;  ///< number of values, if uselessly few
  CutTops cut_tops;
  LoneSamples lone;
  Repeats repeats;
  /// Level in the data set's unit, at its rate. Empty for a constant signal and for a record beyond
  /// longest_record_s, which has no measured lines either.
  std::optional<Level> level;
  /// Speed of the shaft in the longest piece; empty like `level`, if too short, and if the speed
  /// over time was recorded.
  std::optional<spectra::ShaftSpeed> shaft;
  FaultLines lines;
  /// order_lines_db() of the longest piece, if the bearing is not described.
  Eigen::ArrayXd order_lines;
  /// Line of a suspect record, if the bearing is not described and a healthy record compares.
  std::optional<UnknownLine> unknown_line;
  std::vector<double> beginning;  ///< the first shown_s, at the data set's sample rate
  EnvelopeSpectrum envelope;      ///< the part that the picture shows
  std::string problem = {};       ///< empty without one

  [[nodiscard]] double length_s() const {
    return static_cast<double>(file_samples) / source.sample_rate_hz;
  }
  /// Returns the length of the longest piece, in s.
  [[nodiscard]] double longest_piece_s() const;
  /// Returns the speed that the shaft certainly shows; else the given one.
  [[nodiscard]] double shown_speed_rpm() const;
  /// Returns the turns of the shaft in the longest piece.
  [[nodiscard]] double turns() const { return longest_piece_s() * source.shaft_speed_rpm / 60; }
};

/// Results of a split of one class with the description's options: the largest stride that gives
/// all windows, or the problem if none does. If a record of the class is unreadable, both are
/// empty, because the record reports the problem.
struct ClassCheck {
  Label label = 0;
  std::size_t records = 0;
  std::size_t stride = 0;           ///< samples
  double overlap = 0;               ///< of a window with the next one, in [0, 1)
  double shared_with_training = 0;  ///< see share_that_meets_training
  std::string problem = {};         ///< empty without one
};

struct DatasetCheck {
  std::vector<RecordCheck> records;  ///< in the order of the description
  std::vector<ClassCheck> classes;   ///< by label
  Exit exit = Exit::done;            ///< bad_input for bad content, else
                                     ///< input_missing if a file is missing
};

/// Returns the healthy record to compare a suspect one with: of the same condition, else of the
/// nearest speed. Null if none has order_lines.
const RecordCheck* healthy_record_for(const RecordCheck& suspect, const DatasetCheck& check,
                                      Label healthy);

/// Reads all files of a description. Continues after an unreadable file.
DatasetCheck check(const signal::Description& description, const std::filesystem::path& data_dir,
                   const signal::RecordsDone& done = {});

}  // namespace piae::inspection
