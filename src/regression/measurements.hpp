#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "signal/protocol.hpp"

namespace piae::regression {

/// One number from a cell of a run.
struct Measured {
  std::string method;
  std::string classifier;  ///< empty for a score
  std::string ratio;       ///< empty for a score
  std::string quantity;  ///< "accuracy" or "kind_accuracy", in [0, 1]; "right_verdicts", of faulty
                         ///< records; or the name of a metric (scoring/quality.hpp)
  std::int64_t seed = 0;
  double value = 0;  ///< mean over the fault classes for a metric
};

/// All numbers of a run on one data set, and the settings that made them. There are several
/// versions or settings if the cells come from several builds or machines.
struct Measurements {
  std::string dataset;
  signal::Protocol protocol = signal::Protocol::random;  ///< of the splits
  std::vector<Measured> values = {};
  std::set<std::string> versions = {};  ///< of the programs, with their commits
  std::set<std::string> settings = {};  ///< processor, threads, compiler and libraries, in one text
};

/// Returns the reference file of a data set and protocol: FOLDER/PROTOCOL/DATASET.csv.
std::filesystem::path reference_file(const std::filesystem::path& folder, signal::Protocol protocol,
                                     const std::string& dataset);

/// Lists the data sets with a reference in a folder, in alphabetical order.
std::vector<std::string> reference_datasets(const std::filesystem::path& folder,
                                            signal::Protocol protocol);

/// Returns the contents of a reference file: comments that record the settings, then
/// method,classifier,ratio,quantity,seed,value. Values have enough digits to read the same number
/// back.
std::string reference_csv(const Measurements& measurements);

/// Reads a reference file. Throws Error(input_missing) if it does not exist, with the command that
/// makes it, and Error(bad_input), with the line, for anything that reference_csv() does not write.
Measurements read_reference(const std::filesystem::path& folder, signal::Protocol protocol,
                            const std::string& dataset);

}  // namespace piae::regression
