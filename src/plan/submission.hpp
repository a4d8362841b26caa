#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "plan/request.hpp"
#include "plan/step_states.hpp"

namespace piae::plan {

/// The last submission of a run to Slurm, and the state of its jobs (jobs/ended.sh).
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

/// Reads the lines of jobs/ended.sh, with tabs between the words: "submission FOLDER", "queue KIND
/// STATE REASON", "ended JOB WHY"; and what the submission was from its folder.
Submission read_submission(std::istream& lines);

/// Takes the goal of the submission where none is asked for, and where it is that goal, the lists
/// that are not given.
void take_submission(const Submission& submission, Request& request, bool any_goal_given);

EndedJobs ended_jobs(const Submission& submission);

/// The jobs in the queue by their kinds, those that ended otherwise than well, and what was spent;
/// empty where there is nothing to say.
std::string listed_jobs(const Submission& submission);

}  // namespace piae::plan
