#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace piae::run {

/// End of a step of a run.
enum class StepEnd {
  done,
  interrupted,  ///< stopped by a signal: the same command continues from its checkpoint
  failed,
  open,  ///< running, or killed
};

/// Contents of the log next to an artefact (pipeline/step.sh) about the step that makes it.
struct StepLog {
  std::filesystem::path file = {};
  std::string stage = {};  ///< "train"
  StepEnd end = StepEnd::open;
  std::optional<double> started_s = {};  ///< seconds since 1970
  double elapsed_s = 0;                  ///< 0 until it ends
  bool went_on = false;  ///< continued from a checkpoint: earlier time is not in the log
  std::optional<double> processor_s = {};  ///< of all threads; missing in logs of older runs
  std::optional<double> memory_mb = {};    ///< peak, in 10^6 bytes
  std::string reason = {};         ///< error line of a failed step, without the program's name
  int exit_code = 0;               ///< 0 until it ends
  std::string last_progress = {};  ///< last reported progress: "train  ####....   40 %"
};

/// Throws Error(input_missing) if the file cannot be read.
StepLog read_step_log(const std::filesystem::path& file);

/// Reads the logs of a folder and all folders below it, sorted by start, then name. Files are named
/// relative to the folder. Skips logs without a step.
std::vector<StepLog> read_step_logs(const std::filesystem::path& folder);

}  // namespace piae::run
