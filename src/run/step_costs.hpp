#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace piae::run {

/// Cost of a kind of step, measured in an earlier run: a line of jobs/costs.csv. Fields that a
/// stage does not have are empty.
struct StepCost {
  std::string stage;
  std::string dataset;
  std::string method;
  std::string classifier;
  std::string ratio;
  double seconds = 0;    ///< of processor time
  double megabytes = 0;  ///< peak memory
};

/// Reads a table such as jobs/costs.csv: stage,dataset,method,classifier,ratio,seconds,megabytes.
/// Throws as text::read_csv() does, and Error(bad_input), with the line, for another header or a
/// cost that is not a number.
std::vector<StepCost> read_costs(const std::filesystem::path& file);

/// Returns the seconds of processor time to train a generator for one seed and to generate its
/// windows; nothing if the table lacks one of these steps.
std::optional<double> generator_seconds(const std::vector<StepCost>& costs,
                                        const std::string& dataset, const std::string& method);

}  // namespace piae::run
