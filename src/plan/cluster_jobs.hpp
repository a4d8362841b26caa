#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plan/costs.hpp"
#include "plan/plan.hpp"

namespace piae::plan {

/// Jobs of one kind: `records` (all others wait for them), `cells` (steps of some methods and
/// seeds), `cells-gpu` (the same steps on a GPU), `tables` (everything made from cells).
struct JobKind {
  std::string name;
  std::size_t cores = 1;                             ///< of each job
  double minutes = 0;                                ///< limit of each job
  double megabytes = 0;                              ///< memory of each job
  std::size_t steps = 0;                             ///< of all jobs together
  double seconds = 0;                                ///< processor time of all jobs together
  std::vector<std::vector<std::string>> files = {};  ///< files that each job makes, in order
};

/// Divides the steps to be run among jobs with `cores` cores and about `minutes` minutes each, by
/// the costs of earlier runs. The smallest unit is the steps of one method and seed, which wait for
/// one another. The longest units go first, each to the job with the least work. A job never mixes
/// two runs.
std::vector<JobKind> divide(Plan& plan, const Costs& costs, std::size_t cores, double minutes);

/// Returns the kinds as a table for people.
std::string table_of(const std::vector<JobKind>& kinds);

/// Writes into a folder one list for each job, such as cells.3, of the files that the job makes;
/// and the file `jobs`, with a line for each kind: name, number, cores, minutes and megabytes,
/// separated by tabs.
void write_jobs(const std::vector<JobKind>& kinds, const std::filesystem::path& folder);

}  // namespace piae::plan
