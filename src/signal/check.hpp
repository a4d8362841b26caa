#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "signal/description.hpp"
#include "signal/ingest.hpp"

namespace piae::signal {

/// What was found of one record. A record that cannot be read has a problem, and no numbers.
struct RecordCheck {
  RecordSource source;
  std::size_t samples = 0;   ///< at the dataset's sample rate
  double rms = 0;            ///< about the mean, in the unit of the source
  std::string problem = {};  ///< empty where there is none
};

/// What a split with its default options would find of one class: the largest stride that gives all
/// windows, or the problem that there is no such stride. Where a record of the class cannot be read
/// there is neither stride nor problem: the record has the problem already.
struct ClassCheck {
  Label label = 0;
  std::size_t records = 0;
  std::size_t stride = 0;    ///< samples
  std::string problem = {};  ///< empty where there is none
};

struct DatasetCheck {
  std::vector<RecordCheck> records;  ///< in the order of the description
  std::vector<ClassCheck> classes;   ///< by label
  Exit exit = Exit::done;            ///< bad_input if a file holds what it must not, else
                                     ///< input_missing if a file is missing
};

/// Reads all files that a description names, and goes on after a file that cannot be read.
DatasetCheck check(const Description& description, const std::filesystem::path& data_dir,
                   const RecordsDone& done = {});

}  // namespace piae::signal
