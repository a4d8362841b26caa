#pragma once

#include <string>
#include <vector>

#include "page/html.hpp"
#include "run/step_log.hpp"

namespace piae::page {

/// Returns "0.4 s", "12 s", "5.2 min", "3.1 h".
std::string duration_label(double seconds);

/// Returns a moment in seconds since 1970 as "2025-11-22 12:46 UTC".
std::string moment_label(double seconds_since_1970);

/// A period in which steps ran without a long pause.
struct Session {
  double begin_s;  ///< since 1970
  double end_s;
};

/// Returns the sessions of steps, which must be ordered by begin. A pause of more than ten minutes
/// separates two sessions, because a run may continue days after an interruption.
std::vector<Session> sessions_of(const std::vector<run::StepLog>& steps);

/// Returns a picture with a row for each stage and a bar for each step; overlapping bars lie in
/// lanes. Cuts out the pauses between sessions. Expects at least one step, ordered by begin.
Html time_line(const std::vector<run::StepLog>& steps);

/// Returns stages in the order of a run; others follow in alphabetical order.
std::vector<std::string> stages_in_order(const std::vector<run::StepLog>& steps);

/// Returns "done", "failed", ...
std::string word_of(run::StepEnd end);

}  // namespace piae::page
