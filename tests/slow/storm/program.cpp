#include "storm/program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace piae::storm {

namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

/// Returns the first 100 kB that were written.
std::string text_in(std::FILE* file) {
  constexpr std::size_t most = 100000;
  std::string text(most, '\0');
  std::rewind(file);
  text.resize(std::fread(text.data(), 1, most, file));
  return text;
}

[[noreturn]] void become(const fs::path& folder, const std::vector<std::string>& command, int out,
                         int err) {
  std::vector<char*> argv;
  argv.reserve(command.size() + 1);
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  ::setpgid(0, 0);
  ::setenv("OMP_NUM_THREADS", "1", 1);
  const int in = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const bool ready = ::chdir(folder.c_str()) == 0 && ::dup2(in, STDIN_FILENO) >= 0 &&
                     ::dup2(out, STDOUT_FILENO) >= 0 && ::dup2(err, STDERR_FILENO) >= 0;
  if (ready) ::execv(argv.front(), argv.data());
  ::_exit(127);
}

/// True if the process ends within the limit.
bool ends_in_time(pid_t pid) {
  const int fd = static_cast<int>(::syscall(SYS_pidfd_open, pid, 0));
  if (fd < 0) throw std::runtime_error("pidfd_open failed");
  pollfd ended{fd, POLLIN, 0};
  const int count = ::poll(&ended, 1, static_cast<int>(most_seconds * 1000));
  ::close(fd);
  return count > 0;
}

}  // namespace

bool is_model(const fs::path& file) {
  return file.filename().string().find(".model.") != std::string::npos;
}

bool took_too_much(const Outcome& outcome, const fs::path& file) {
  const bool makes_windows = outcome.status == 0 && is_model(file);
  return outcome.peak_mb > (makes_windows ? 2 * most_mb : most_mb);
}

Outcome run(const fs::path& folder, const std::vector<std::string>& command) {
  const File out(std::tmpfile());
  const File err(std::tmpfile());
  if (!out || !err) throw std::runtime_error("no temporary file");
  const auto started = std::chrono::steady_clock::now();
  const pid_t pid = ::fork();
  if (pid == 0) become(folder, command, ::fileno(out.get()), ::fileno(err.get()));
  if (pid < 0) throw std::runtime_error("fork failed");
  ::setpgid(pid, pid);
  Outcome outcome;
  outcome.hung = !ends_in_time(pid);
  // Kills the program's children, too.
  ::kill(-pid, SIGKILL);
  int status = 0;
  rusage used{};
  ::wait4(pid, &status, 0, &used);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  outcome.peak_mb = static_cast<double>(used.ru_maxrss) / 1024;
  outcome.out = text_in(out.get());
  outcome.err = text_in(err.get());
  return outcome;
}

}  // namespace piae::storm
