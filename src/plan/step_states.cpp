#include "plan/step_states.hpp"

#include <fcntl.h>
#include <spdlog/fmt/fmt.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

#include "base/error.hpp"

namespace piae::plan {

namespace {

const std::string guess = "killed, perhaps for want of memory";  // text in pipeline/step.sh

/// Returns why the job that was to run a step ended; empty if it did not end or the reason is
/// unknown.
std::string job_ended(const Step& step, const EndedJobs& jobs) {
  if (!step.is_artefact) return jobs.of_tables;
  for (const std::string& output : step.outputs) {
    const auto found = jobs.by_file.find(output);
    if (found != jobs.by_file.end()) return found->second;
  }
  return {};
}

/// Returns why a step failed: its own reason unless that was only a guess; else the reason of its
/// job; else its exit code.
std::string reason_of(const run::StepLog& log, const std::string& job) {
  const bool only_guessed = log.reason.ends_with(guess);
  if (!log.reason.empty() && !only_guessed) return log.reason;
  const bool job_reports = !job.empty() && (job != "some steps failed" || log.exit_code == 0);
  if (job_reports) return "its job ended: " + job;
  return log.reason.empty() ? fmt::format("exit code {}", log.exit_code) : log.reason;
}

StepState state_of(const Step& step, Logs& logs, const EndedJobs& jobs) {
  const std::string file = log_of(step);
  const std::optional<run::StepLog> log = logs.read(file);
  if (!log) return {};
  const std::string job = job_ended(step, jobs);
  switch (log->end) {
    case run::StepEnd::failed:
      return {Progress::failed, log->exit_code, reason_of(*log, job)};
    case run::StepEnd::open:
      if (logs.is_locked(file)) return {Progress::running, 0, log->last_progress};
      if (!job.empty()) return {Progress::failed, 0, reason_of(*log, job)};
      return {};
    default:
      return {};  // of older settings, or interrupted
  }
}

}  // namespace

std::optional<run::StepLog> RealLogs::read(const std::string& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return std::nullopt;
  try {
    return run::read_step_log(file);
  } catch (const Error&) {
    return std::nullopt;
  }
}

bool RealLogs::is_locked(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

std::map<StepId, StepState> step_states(Plan& plan, Logs& logs, const EndedJobs& jobs) {
  std::map<StepId, StepState> states;
  for (const StepId id : plan.to_run()) {
    states[id] = state_of(plan.graph().at(id), logs, jobs);
  }
  return states;
}

}  // namespace piae::plan
