#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "signal/description.hpp"
#include "signal/ingest.hpp"

namespace piae::signal {

/// What was found of one record. Of one that cannot be read there is only the problem.
struct RecordCheck {
  const RecordSource* source = nullptr;
  std::size_t samples = 0;  ///< at the dataset's sample rate
  double rms = 0;           ///< about the mean, in the unit of the source
  std::string problem;      ///< empty: none
};

/// What a split with its default options would find of one class: the largest stride that gives all
/// windows, or why there is none. Neither where a record of the class cannot be read.
struct ClassCheck {
  int label = 0;
  std::size_t records = 0;
  std::size_t stride = 0;  ///< samples
  std::string problem;     ///< empty: none
};

struct DatasetCheck {
  std::vector<RecordCheck> records;  ///< as in the description
  std::vector<ClassCheck> classes;   ///< by label
  Exit exit = Exit::done;            ///< bad_input if any problem is one of content, else
                                     ///< input_missing if a file is missing
};

/// Reads all that a description names, and goes on after what cannot be read.
DatasetCheck check(const Description& description, const std::filesystem::path& data_dir,
                   const RecordsDone& done = {});

}  // namespace piae::signal
