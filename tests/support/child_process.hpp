#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "base/error.hpp"

namespace piae {

/// Runs an action in a child process. Returns its exit status, or 128 plus the signal.
inline int status_of_child(const std::function<void()>& action) {
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      action();
    } catch (const Error& error) {
      ::_exit(static_cast<int>(error.exit()));
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace piae
