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
  double megabytes = 0;  ///< of memory, the most at a time
};

/// Costs of steps that were run elsewhere, by stage, data set, method, classifier and ratio.
class Costs {
 public:
  /// Reads a table such as jobs/costs.csv: stage,dataset,method,classifier,ratio,seconds,megabytes.
  /// Lines that begin with # are left out. Throws Error(bad_input), with the line, for anything
  /// else, and Error(input_missing) where there is no such file.
  static Costs read(const std::filesystem::path& file);

  void learn(const std::string& stage, const Place& place, const Cost& cost);

  /// The most that the steps took which are most like this one. Methods have no training in common:
  /// of one that is not known the longest is taken, and `is_guess` says so.
  struct Estimate {
    Cost cost;
    bool is_guess = false;
  };
  [[nodiscard]] Estimate of(const Step& step) const;

 private:
  std::map<std::string, Cost> known_;
};

/// What the steps of a plan took, by their logs, in the form of jobs/costs.csv: the mean of the
/// seconds, the most memory. Steps with a setting moved take as long as their method, and are left
/// out.
std::string measured_costs(const Plan& plan, Logs& logs);

}  // namespace piae::plan
