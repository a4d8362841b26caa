#pragma once

#include <stdexcept>
#include <string>

namespace piae {

/// Exit codes of every program. `verify` alone uses others: the bit-or of its reasons to refuse
/// files (artefact::RefusalReason).
enum class Exit : int {
  done = 0,
  failed = 1,
  usage = 2,
  bad_input = 65,
  input_missing = 66,
  interrupted = 75,  // stopped after a checkpoint: run the same command again
};

/// Thrown if something cannot be done. The message is the one line that the user sees: what, where,
/// and what would work.
class Error : public std::runtime_error {
 public:
  Error(Exit exit, const std::string& line) : std::runtime_error(line), exit_(exit) {}
  [[nodiscard]] Exit exit() const { return exit_; }

 private:
  Exit exit_;
};

}  // namespace piae
