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
#include "inspection/value_counts.hpp"
#include "signal/description.hpp"
#include "signal/ingest.hpp"

namespace piae::inspection {

/// A record of more than an hour is no single run at a steady speed. Such a one is not brought to
/// the dataset's rate, since a rate in kHz would make it a thousand times longer than it is.
inline constexpr double longest_record_s = 3600;

/// Fewer turns of the shaft in one piece show no rhythm.
inline constexpr double fewest_turns = 10;

/// How much of a record the picture shows.
inline constexpr double shown_s = 0.2;

/// One of the files of a record.
struct FileCheck {
  std::string name;
  std::size_t samples = 0;  ///< as it has them
  std::size_t columns = 0;  ///< of a text file; else 0
  raw::Times times = {};    ///< of a text file
};

/// What was found of one record. A record that cannot be read has a problem, and no numbers.
struct RecordCheck {
  signal::RecordSource source;
  std::size_t file_samples = 0;  ///< as the file has them
  /// Samples of each file at the dataset's sample rate.
  std::vector<std::size_t> pieces;
  std::vector<FileCheck> files;  ///< in the order of their samples
  bool goes_one_way = false;
  Stretches clipped;
  Stretches held;
  std::optional<std::size_t> few_values;  ///< where the record takes so few that it is useless
  CutTops cut_tops;
  LoneSamples lone;
  Repeats repeats;
  /// In the unit of the source, at the dataset's rate. None for a record beyond longest_record_s,
  /// which then has no lines either.
  std::optional<Level> level;
  FaultLines lines;
  std::vector<double> beginning;  ///< the first shown_s, at the dataset's sample rate
  EnvelopeSpectrum envelope;      ///< as far as the picture shows it
  std::string problem = {};       ///< empty where there is none

  [[nodiscard]] double length_s() const {
    return static_cast<double>(file_samples) / source.sample_rate_hz;
  }
  /// Gives the time in one piece, at most.
  [[nodiscard]] double longest_piece_s() const;
  /// Gives the turns of the shaft in that time.
  [[nodiscard]] double turns() const { return longest_piece_s() * source.shaft_speed_rpm / 60; }
};

/// What a split with its default options would find of one class: the largest stride that gives all
/// windows, or the problem that there is no such stride. Where a record of the class cannot be read
/// there is neither stride nor problem: the record has the problem already.
struct ClassCheck {
  Label label = 0;
  std::size_t records = 0;
  std::size_t stride = 0;           ///< samples
  double overlap = 0;               ///< of a window with the next one: 0 to below 1
  double shared_with_training = 0;  ///< see share_that_meets_training
  std::string problem = {};         ///< empty where there is none
};

struct DatasetCheck {
  std::vector<RecordCheck> records;  ///< in the order of the description
  std::vector<ClassCheck> classes;   ///< by label
  Exit exit = Exit::done;            ///< bad_input if a file holds what it must not, else
                                     ///< input_missing if a file is missing
};

/// Reads all files that a description names, and goes on after a file that cannot be read.
DatasetCheck check(const signal::Description& description, const std::filesystem::path& data_dir,
                   const signal::RecordsDone& done = {});

}  // namespace piae::inspection
