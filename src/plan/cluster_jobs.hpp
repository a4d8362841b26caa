#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plan/costs.hpp"
#include "plan/plan.hpp"

namespace piae::plan {

/// Jobs of one kind: `records` makes what all others wait for, `cells` the steps of some methods
/// and seeds, `cells-gpu` those of them that need a GPU, `tables` all that is made of cells.
struct JobKind {
  std::string name;
  std::size_t cores = 1;                             ///< of each job
  double minutes = 0;                                ///< of each job, at most
  double megabytes = 0;                              ///< of memory, of each job
  std::size_t steps = 0;                             ///< of all of them
  double seconds = 0;                                ///< of processor time, of all of them
  std::vector<std::vector<std::string>> files = {};  ///< what each job makes, in order
};

/// Divides the steps that are to be run among jobs of so many cores, each of which takes about so
/// many minutes, by what steps took elsewhere. What cannot be divided is a unit: the steps of one
/// method of one seed, which wait for one another. The longest go first, each to the job that has
/// least to do. No job is of two runs.
std::vector<JobKind> divide(Plan& plan, const Costs& costs, std::size_t cores, double minutes);

/// The kinds as a table for people; with the steps whose cost nobody knows.
std::string table_of(const std::vector<JobKind>& kinds);

/// Writes into a folder what each job makes, a file for each, such as cells.3; and `jobs`, a line
/// for each kind with its name, number, cores, minutes and megabytes, with tabs between them.
void write_jobs(const std::vector<JobKind>& kinds, const std::filesystem::path& folder);

}  // namespace piae::plan
