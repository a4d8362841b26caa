#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "classification/recording.hpp"
#include "cli/stage.hpp"
#include "signal/dataset_info.hpp"

namespace piae::classification {

/// Recordings to classify: a single file, or those of a description or of records.h5.
struct Sources {
  LoneFile lone;
  std::filesystem::path description;
  std::filesystem::path data_dir = "data";
  std::filesystem::path records_file;
  std::vector<std::string> records;  ///< their names; all if empty
  std::vector<std::string> healthy;  ///< names of healthy records, for a network for all machines
  double speed_search_percent = 0;   ///< see Fit
};

void bind(cli::Stage& stage, Sources& sources);

/// Throws Error(usage) unless exactly one of the three is named, a single file with its variable,
/// sample rate and shaft speed.
void require_one(const Sources& sources);

/// Throws Error(usage) if healthy records are named, for a classifier that knows its machine.
void require_no_healthy_records(const Sources& sources);

/// Reads the recordings at the sample rate of the training, with the speed search of the sources,
/// and records the files as inputs of the stage. Throws as read_lone_file(), read_described() and
/// read_recorded() do.
std::vector<Recording> read(cli::Stage& stage, const Sources& sources,
                            const diagnosis::Classifier& classifier,
                            const signal::DatasetInfo& trained);

}  // namespace piae::classification
