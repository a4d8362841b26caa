#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace piae::run {

/// How a step of a run ended.
enum class StepEnd {
  done,
  interrupted,  ///< stopped by a signal: the same command goes on from there
  failed,
  open,  ///< it is running, or was killed
};

/// What the log beside an artefact says of the step that made it, or should have
/// (pipeline/step.sh).
struct StepLog {
  std::filesystem::path file = {};
  std::string stage = {};  ///< "train"
  StepEnd end = StepEnd::open;
  std::optional<double> begun_s = {};  ///< seconds since 1970
  double elapsed_s = 0;                ///< 0 while it is not ended
  bool went_on = false;                ///< from a checkpoint: what it took before is not in the log
  std::optional<double> processor_s =
      {};                                ///< of all its threads; logs of older runs do not have it
  std::optional<double> memory_mb = {};  ///< the most that it held at a time, in 10^6 bytes
  std::string reason = {};               ///< of a failed step: its error line, without its name
  int exit_code = 0;                     ///< 0 while it is not ended
  std::string last_progress = {};        ///< "train  ####....   40 %": how far it has said to be
};

/// Throws Error(input_missing) for a file that cannot be read.
StepLog read_step_log(const std::filesystem::path& file);

/// Those of a folder and all below it, by begin, then name. Files are named relative to the folder.
/// A log that holds no step is left out.
std::vector<StepLog> read_step_logs(const std::filesystem::path& folder);

}  // namespace piae::run
