#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace piae::regression {

/// One number that a cell of a run gives.
struct Measured {
  std::string method;
  std::string ratio;     ///< of a diagnosis; empty for a score, which has none
  std::string quantity;  ///< "accuracy", in [0, 1]; or a metric of scoring/quality.hpp, its mean
                         ///< over the fault classes
  std::int64_t seed = 0;
  double value = 0;
};

/// What a run has measured on one dataset, and what made it. More than one entry where its cells
/// come from several builds or machines.
struct Measurements {
  std::string dataset;
  std::string protocol;  ///< of the split: "random", "blocked"
  std::vector<Measured> values;
  std::set<std::string> versions;  ///< of the programs, with the commit
  std::set<std::string> settings;  ///< processor, threads, compiler and libraries, in one text
};

/// Where the reference for a dataset and protocol is kept below its folder.
std::filesystem::path reference_file(const std::filesystem::path& folder,
                                     const std::string& protocol, const std::string& dataset);

/// Datasets for which a folder has a reference, in alphabetical order.
std::vector<std::string> reference_datasets(const std::filesystem::path& folder,
                                            const std::string& protocol);

/// The reference as a file: comments that say what made it, then method,ratio,quantity,seed,value
/// with as many digits as it takes to get the same number back.
std::string reference_csv(const Measurements& measurements);

/// Throws Error(input_missing) that says how to make one, when there is none; Error(bad_input)
/// naming the line for what reference_csv() cannot have written.
Measurements read_reference(const std::filesystem::path& folder, const std::string& protocol,
                            const std::string& dataset);

}  // namespace piae::regression
