#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "run/step_log.hpp"

namespace piae::plan {

/// How far a step is that is not current, the worst last.
enum class Progress { done, missing, running, failed };

struct StepState {
  Progress progress = Progress::missing;
  int exit_code = 0;  ///< of a failed step; 0 where it ended together with its job
  std::string said;   ///< of a failed step the reason, of a running one how far it is
};

/// Reads the logs of steps.
class Logs {
 public:
  Logs() = default;
  Logs(const Logs&) = delete;
  Logs& operator=(const Logs&) = delete;
  virtual ~Logs() = default;

  /// Empty where there is no log.
  virtual std::optional<run::StepLog> read(const std::string& file) = 0;
  /// True if a process has the log locked, which it does while its step runs.
  virtual bool is_locked(const std::string& file) = 0;
};

class RealLogs : public Logs {
 public:
  std::optional<run::StepLog> read(const std::string& file) override;
  bool is_locked(const std::string& file) override;
};

/// Jobs of a cluster that have ended otherwise than well: why, by the file that each was to make,
/// and of the job that makes the tables.
struct EndedJobs {
  std::map<std::string, std::string> by_file;
  std::string of_tables;
};

/// The states of the steps that are asked for and not current.
std::map<StepId, StepState> step_states(Plan& plan, Logs& logs, const EndedJobs& jobs);

}  // namespace piae::plan
