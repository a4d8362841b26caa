#pragma once

#include <string>
#include <vector>

#include "page/html.hpp"
#include "run/step_log.hpp"

namespace piae::page {

/// "0.4 s", "12 s", "5.2 min", "3.1 h".
std::string duration_label(double seconds);

/// A moment in seconds since 1970 as "2025-11-22 12:46 UTC".
std::string moment_label(double seconds_since_1970);

/// A time in which steps ran, without a longer pause.
struct Session {
  double begin_s;  ///< since 1970
  double end_s;
};

/// The sessions of steps, which must be ordered by begin. A pause of ten minutes parts two of them:
/// a run may go on days after it was interrupted.
std::vector<Session> sessions_of(const std::vector<run::StepLog>& steps);

/// A picture with a row for each stage and a bar for each step; bars that overlap lie in lanes.
/// Pauses between sessions are cut out. Steps are ordered by begin, and there is at least one.
Html time_line(const std::vector<run::StepLog>& steps);

/// Stages in the order in which a run has them; others follow in alphabetical order.
std::vector<std::string> stages_in_order(const std::vector<run::StepLog>& steps);

/// "done", "failed", ...
std::string word_of(run::StepEnd end);

}  // namespace piae::page
