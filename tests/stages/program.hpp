#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

/// Runs the built programs as a user does.
namespace piae::stages {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

/// Exit status and output of a program.
struct Outcome {
  int status = -1;  ///< exit status; 128 + signal if a signal ended it, as in the shell
  std::string out;
  std::string err;
  long peak_kb = 0;  ///< peak memory
};

/// Conditions of a run in addition to its arguments.
struct Surroundings {
  std::vector<std::pair<std::string, std::string>> environment = {{"OMP_NUM_THREADS", "1"}};
  rlim_t largest_file = RLIM_INFINITY;  ///< bytes; a write beyond fails as on a full disk
  rlim_t most_memory = RLIM_INFINITY;   ///< bytes of address space
  bool without_root_rights = false;     ///< permissions of files hold even for root
  fs::path input{};                     ///< standard input; empty for the test's own
};

inline std::string read_all(std::FILE* file) {
  std::string text;
  std::rewind(file);
  for (int c = 0; (c = std::fgetc(file)) != EOF;) text.push_back(static_cast<char>(c));
  return text;
}

/// A run of a stage in a folder. The destructor kills it if nobody waits for it.
class Process {
 public:
  Process(const fs::path& folder, const std::string& stage, const Arguments& arguments,
          const Surroundings& surroundings = {})
      : command_(stage), out_(std::tmpfile()), err_(std::tmpfile()) {
    for (const std::string& argument : arguments) command_ += ' ' + argument;
    const std::string program = std::string(PIAE_BIN) + '/' + stage;
    std::vector<std::string> texts{program};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    argv.reserve(texts.size() + 1);
    for (std::string& text : texts) argv.push_back(text.data());
    argv.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ == 0) become(folder, argv, surroundings);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
    std::fclose(out_);
    std::fclose(err_);
  }

  void send(int signal) const { ::kill(pid_, signal); }

  /// Waits until the program catches SIGTERM itself, or has ended.
  void wait_until_it_catches_sigterm() const {
    while (!ended()) {
      std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
      for (std::string line; std::getline(status, line);) {
        if (!line.starts_with("SigCgt:")) continue;
        const std::uint64_t caught = std::stoull(line.substr(7), nullptr, 16);
        if ((caught >> (SIGTERM - 1) & 1U) != 0) return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  /// Wait until the program has written this on standard output or standard error, or has ended.
  void wait_until_it_says(const std::string& text) const { wait_until_it_is_in(out_, text); }
  void wait_until_it_warns(const std::string& text) const { wait_until_it_is_in(err_, text); }

  /// Waits for the end. After two minutes the program counts as hanging: it is killed, and the test
  /// fails.
  Outcome wait() {
    int status = 0;
    rusage usage{};
    const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (::wait4(pid_, &status, WNOHANG, &usage) == 0) {
      if (std::chrono::steady_clock::now() > limit) {
        ADD_FAILURE() << command_ << ": hangs";
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, &status, 0);
        break;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    pid_ = -1;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, read_all(out_), read_all(err_), usage.ru_maxrss};
  }

 private:
  /// Becomes the program, in the child process.
  [[noreturn]] void become(const fs::path& folder, const std::vector<char*>& argv,
                           const Surroundings& surroundings) const {
    for (const auto& [name, value] : surroundings.environment) {
      ::setenv(name.c_str(), value.c_str(), 1);
    }
    if (surroundings.without_root_rights) {
      ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0);
      ::prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH, 0, 0, 0);
    }
    const rlimit limit{surroundings.largest_file, surroundings.largest_file};
    const rlimit memory{surroundings.most_memory, surroundings.most_memory};
    const bool limited = surroundings.largest_file != RLIM_INFINITY;
    if (limited) ::signal(SIGXFSZ, SIG_IGN);  // write() then fails with EFBIG
    const bool ready = ::chdir(folder.c_str()) == 0 && becomes_input(surroundings.input) &&
                       ::dup2(fileno(out_), STDOUT_FILENO) >= 0 &&
                       ::dup2(fileno(err_), STDERR_FILENO) >= 0 &&
                       (!limited || ::setrlimit(RLIMIT_FSIZE, &limit) == 0) &&
                       (memory.rlim_cur == RLIM_INFINITY || ::setrlimit(RLIMIT_AS, &memory) == 0);
    if (ready) ::execv(argv.front(), argv.data());
    ::_exit(127);
  }

  /// Opens standard input. A pipe blocks until it has a writer.
  static bool becomes_input(const fs::path& path) {
    if (path.empty()) return true;
    return ::dup2(::open(path.c_str(), O_RDONLY), STDIN_FILENO) >= 0;
  }

  void wait_until_it_is_in(std::FILE* stream, const std::string& text) const {
    while (printed(stream).find(text) == std::string::npos && !ended()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  /// Returns the output so far, without moving the write position.
  [[nodiscard]] static std::string printed(std::FILE* stream) {
    std::string text;
    char buffer[4096];
    for (ssize_t got = 0; (got = ::pread(fileno(stream), buffer, sizeof buffer,
                                         static_cast<off_t>(text.size()))) > 0;) {
      text.append(buffer, static_cast<std::size_t>(got));
    }
    return text;
  }

  [[nodiscard]] bool ended() const {
    siginfo_t info{};
    ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
    return info.si_pid != 0;
  }

  std::string command_;
  std::FILE* out_;
  std::FILE* err_;
  pid_t pid_ = -1;
};

inline Outcome run(const fs::path& folder, const std::string& stage, const Arguments& arguments,
                   const Surroundings& surroundings = {}) {
  return Process(folder, stage, arguments, surroundings).wait();
}

inline bool is_one_line(const std::string& text) {
  return text.size() > 1 && text.find('\n') == text.size() - 1;
}

/// Expects the documented failure: this status, nothing on standard output, and on standard error
/// one line that begins with the stage's name and holds these words.
inline void expect_refusal(const Outcome& outcome, const std::string& stage, int status,
                           const std::vector<std::string>& words) {
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with(stage + ": ")) << outcome.err;
  for (const std::string& word : words) {
    EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " is not in: " << outcome.err;
  }
}

/// True if the programs with LibTorch were built.
inline bool built_with_libtorch() { return fs::exists(fs::path(PIAE_BIN) / "train-libtorch"); }

}  // namespace piae::stages

#define SKIP_WITHOUT_LIBTORCH()                                 \
  if (!::piae::stages::built_with_libtorch()) {                 \
    GTEST_SKIP() << "the programs were built without LibTorch"; \
  }
