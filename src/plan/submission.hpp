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
  std::filesystem::path
      folder;  ///< with the lists and logs of its jobs; empty where there was none
  std::string goal;
  std::vector<std::string> variables;  ///< "SEEDS=0 1"

  struct Queued {
    std::string kind;   ///< "cells.3", or "?" where Slurm does not answer
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

/// Reads the lines of jobs/queue.sh, with tabs between the words: "submission FOLDER", "queue KIND
/// STATE REASON"; and from the folder the request and the logs of the jobs, since Slurm forgets a
/// job after some minutes. Where Slurm does not answer, a log without an end may be that of a job
/// that runs: it is not among those that ended.
Submission read_submission(std::istream& lines);

/// Takes the goal of the submission where none is asked for, and where it is that goal, the lists
/// that are not given.
void take_submission(const Submission& submission, Request& request, bool any_goal_given);

EndedJobs ended_jobs(const Submission& submission);

/// The jobs in the queue by their kinds, those that ended otherwise than well, and what was spent;
/// empty where there is nothing to say.
std::string listed_jobs(const Submission& submission);

/// Says what the jobs of the submission in this folder spent until now (spent_by). Steps are
/// counted by their logs.
std::string spent_by_submission(const std::filesystem::path& folder);

}  // namespace piae::plan
