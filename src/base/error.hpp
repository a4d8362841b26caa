#pragma once

#include <stdexcept>
#include <string>

namespace piae {

/// Exit codes of every program. `verify` alone answers with a bit-or of reasons instead.
enum class Exit : int {
  done = 0,
  failed = 1,
  usage = 2,
  bad_input = 65,
  input_missing = 66,
  interrupted = 75,  // stopped after a checkpoint: run the same command again
};

/// What a user sees when something cannot be done: one line that says what, where, and what would
/// work, and the exit code that goes with it.
class Error : public std::runtime_error {
 public:
  Error(Exit exit, const std::string& line) : std::runtime_error(line), exit_(exit) {}
  [[nodiscard]] Exit exit() const { return exit_; }

 private:
  Exit exit_;
};

}  // namespace piae
