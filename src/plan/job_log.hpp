#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace piae::plan {

/// One stay of a job on a node. A requeued job has several.
struct JobLife {
  double start_s = 0;  ///< since 1970, as all times here
  int cores = 1;
  std::optional<double> end_s;  ///< empty if it was killed or still runs
  double used_s = 0;            ///< processor time; 0 without an end
};

/// Contents of the log of a cluster job (jobs/job.sbatch).
struct JobLog {
  std::string job;  ///< "cells.3"
  std::vector<JobLife> lives = {};
  std::string why = {};  ///< reason of a failure; "killed" if the last life has no end
};

/// Parses the lines of jobs/job.sbatch and Slurm's messages between them.
JobLog read_job_log(const std::string& job, const std::vector<std::string>& lines);

/// Returns lines that begin with "spent: ": core-hours, and how long all jobs waited in the queue.
/// The job that makes the tables still runs: its life ends at `now_s`. `steps` is the number of
/// steps that the jobs completed.
std::string spent_by(const std::vector<JobLog>& jobs, double submitted_s, double now_s,
                     std::size_t steps);

}  // namespace piae::plan
