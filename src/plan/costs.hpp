#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "plan/step_states.hpp"

namespace piae::plan {

/// Processor time and memory of a step.
struct Cost {
  double seconds = 0;    ///< of processor time
  double megabytes = 0;  ///< peak memory
};

/// Costs of steps in earlier runs, by stage, data set, method, classifier and ratio.
class Costs {
 public:
  /// Reads a table such as jobs/costs.csv. Throws as run::read_costs() does.
  static Costs read(const std::filesystem::path& file);

  void learn(const std::string& stage, const Place& place, const Cost& cost);

  /// The highest cost of the most similar steps. Methods train differently: for an unknown method
  /// the longest training is taken, and `is_guess` is true.
  struct Estimate {
    Cost cost;
    bool is_guess = false;
  };
  [[nodiscard]] Estimate of(const Step& step) const;

 private:
  std::map<std::string, Cost> known_;
};

/// Returns the costs of a plan's steps, from their logs, in the form of jobs/costs.csv: mean
/// seconds and highest memory. Leaves out steps with a moved setting, which take as long as their
/// method.
std::string measured_costs(const Plan& plan, Logs& logs);

}  // namespace piae::plan
