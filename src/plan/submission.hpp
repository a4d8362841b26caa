#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "plan/request.hpp"
#include "plan/step_states.hpp"

namespace piae::plan {

/// The last submission of a run to Slurm, and the state of its jobs.
struct Submission {
  std::filesystem::path folder;  ///< of the lists and logs of its jobs; empty before any submission
  std::string goal;
  std::vector<std::string> variables;  ///< "SEEDS=0 1"

  struct Queued {
    std::string kind;   ///< "cells.3", or "?" if Slurm does not answer
    std::string state;  ///< "PENDING"
    std::string reason;
  };
  std::vector<Queued> queue;

  struct Ended {
    std::string job;  ///< "cells.3"
    std::string why;  ///< "out of memory"
  };
  std::vector<Ended> ended;
};

/// Reads the tab-separated lines of jobs/queue.sh: "submission FOLDER", "queue KIND STATE REASON".
/// Reads the request and the logs of the jobs from the folder, because Slurm forgets a job after
/// some minutes. If Slurm does not answer, a job without an end in its log may still run, so it
/// does not count as ended.
Submission read_submission(std::istream& lines);

/// Completes a request from the submission: its goal if none is given; if the goal is the same, its
/// lists, too, unless they are given.
void take_submission(const Submission& submission, Request& request, bool any_goal_given);

EndedJobs ended_jobs(const Submission& submission);

/// Lists the jobs in the queue by kind, the failed jobs, and what was spent; empty if there are
/// none.
std::string listed_jobs(const Submission& submission);

/// Returns what the jobs of the submission in this folder have spent so far (see spent_by). Counts
/// steps by their logs.
std::string spent_by_submission(const std::filesystem::path& folder);

}  // namespace piae::plan
