#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "signal/protocol.hpp"

namespace piae::regression {

/// One number that a cell of a run gives.
struct Measured {
  std::string method;
  std::string classifier;  ///< of a diagnosis; a score has none, and this is empty
  std::string ratio;       ///< the same
  std::string quantity;    ///< "accuracy" or "kind_accuracy", in [0, 1], or the name of a metric
                           ///< (scoring/quality.hpp)
  std::int64_t seed = 0;
  double value = 0;  ///< of a metric: its mean over the fault classes
};

/// All numbers of a run on one dataset, and what they were made with. There are several versions or
/// settings where the cells come from several builds or machines.
struct Measurements {
  std::string dataset;
  signal::Protocol protocol = signal::Protocol::random;  ///< of the splits
  std::vector<Measured> values = {};
  std::set<std::string> versions = {};  ///< of the programs, with their commits
  std::set<std::string> settings = {};  ///< processor, threads, compiler and libraries, in one text
};

/// The file that holds the reference for a dataset and protocol: FOLDER/PROTOCOL/DATASET.csv.
std::filesystem::path reference_file(const std::filesystem::path& folder, signal::Protocol protocol,
                                     const std::string& dataset);

/// The datasets for which a folder has a reference, in alphabetical order.
std::vector<std::string> reference_datasets(const std::filesystem::path& folder,
                                            signal::Protocol protocol);

/// What a reference file holds: comments that say what it was made with, then
/// method,classifier,ratio,quantity,seed,value with as many digits as it takes to read the same
/// number back.
std::string reference_csv(const Measurements& measurements);

/// Throws Error(input_missing) when there is none, with the command that makes one, and
/// Error(bad_input) with the line for anything that reference_csv() does not write.
Measurements read_reference(const std::filesystem::path& folder, signal::Protocol protocol,
                            const std::string& dataset);

}  // namespace piae::regression
