#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace piae::plan {

/// The time of a job on a node. A job that goes back into the queue has several.
struct JobLife {
  double start_s = 0;  ///< since 1970, as all times here
  int cores = 1;
  std::optional<double> end_s;  ///< empty where it was killed, or runs
  double used_s = 0;            ///< processor time; known where it has an end
};

/// What the log of a job of a cluster says (jobs/job.sbatch).
struct JobLog {
  std::string job;  ///< "cells.3"
  std::vector<JobLife> lives = {};
  std::string why = {};  ///< it ended other than well; "killed" where its last life has no end
};

/// Reads the lines of jobs/job.sbatch, and what Slurm writes between them.
JobLog read_job_log(const std::string& job, const std::vector<std::string>& lines);

/// Says what jobs spent, in lines that begin with "spent: ": core-hours, and how long all waited in
/// the queue. The job that makes the tables runs: its life ends at `now_s`. `steps` are those that
/// the jobs completed.
std::string spent_by(const std::vector<JobLog>& jobs, double submitted_s, double now_s,
                     std::size_t steps);

}  // namespace piae::plan
