#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "run/step_log.hpp"

namespace piae::plan {

/// Progress of a step that is not current, the worst last.
enum class Progress { done, missing, running, failed };

struct StepState {
  Progress progress = Progress::missing;
  int exit_code = 0;   ///< of a failed step; 0 if it ended together with its job
  std::string reason;  ///< reason of a failed step, progress of a running one
};

/// Reads the logs of steps.
class Logs {
 public:
  Logs() = default;
  Logs(const Logs&) = delete;
  Logs& operator=(const Logs&) = delete;
  virtual ~Logs() = default;

  /// Returns an empty value if the log does not exist.
  virtual std::optional<run::StepLog> read(const std::string& file) = 0;
  /// True if a process has locked the log, as every running step does.
  virtual bool is_locked(const std::string& file) = 0;
};

class RealLogs : public Logs {
 public:
  std::optional<run::StepLog> read(const std::string& file) override;
  bool is_locked(const std::string& file) override;
};

/// Reasons of the cluster jobs that failed, by the files that each was to make, and the reason of
/// the job that makes the tables.
struct EndedJobs {
  std::map<std::string, std::string> by_file;
  std::string of_tables;
};

/// Returns the states of the requested steps that are not current.
std::map<StepId, StepState> step_states(Plan& plan, Logs& logs, const EndedJobs& jobs);

}  // namespace piae::plan
