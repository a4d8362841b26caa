#include "artefact/rehearsal.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <new>
#include <span>
#include <string_view>
#include <system_error>

#include "base/address_space.hpp"
#include "base/write_all.hpp"

namespace piae::artefact {

namespace {

/// Answer of the child for a good file. Other answers start with the number of a reason; a missing
/// answer means that the child died.
constexpr std::string_view good = "good";
/// Ends the answer for each file.
constexpr char end_of_answer = '\0';

void limit(int resource, rlim_t most) {
  rlimit now{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &now) != 0) return;
  now.rlim_cur = std::min({most, now.rlim_cur, now.rlim_max});
  ::setrlimit(static_cast<__rlimit_resource>(resource), &now);
}

/// Returns the address space that suffices to read a good file of this size: present mappings, some
/// for HDF5, and more than the three times its size that reading takes.
std::size_t enough_for(std::size_t size) {
  constexpr std::size_t some = std::size_t{64} << 20U;
  return mapped_bytes() + some + 4 * size;
}

/// Limits the child's address space, and its processor time to a second for each 20 MB or 50 files.
void limit_by_size(std::size_t size, std::size_t files) {
#ifndef __SANITIZE_ADDRESS__  // needs memory to report its findings, and has a limit itself
  limit(RLIMIT_AS, enough_for(size));
#endif
  limit(RLIMIT_CPU, 2 + files / 50 + size / (std::size_t{20} << 20U));
  limit(RLIMIT_CORE, 0);
}

/// True if this process itself has a limit below the needs of a good file of this size.
bool is_short_of_memory(std::size_t size) {
  rlimit now{};
  return ::getrlimit(RLIMIT_AS, &now) == 0 && now.rlim_cur < enough_for(size);
}

std::size_t size_of(std::span<const Rehearsal> files) {
  std::size_t size = 0;
  for (const Rehearsal& file : files) size += file.size;
  return size;
}

/// Sends an answer. A failure counts as the child's death.
void send(int to, std::string text) {
  text += end_of_answer;
  (void)write_all(to, std::as_bytes(std::span(text)));
}

std::string read_all(int from) {
  std::string text;
  std::array<char, 4096> some{};
  for (;;) {
    const ssize_t got = ::read(from, some.data(), some.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(some.data(), static_cast<std::size_t>(got));
  }
}

void rehearse_to(int to, const std::function<void()>& read) {
  try {
    read();
    send(to, std::string(good));
  } catch (const Refusal& refusal) {
    send(to, std::to_string(static_cast<int>(refusal.reason())) + ' ' + refusal.what());
  }
}

/// Runs the child. It ends without the program's exit handlers, and after the first bad file.
[[noreturn]] void be_the_child(int to, std::span<const Rehearsal> files) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // the program's handlers must not run in the child
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGXCPU}) ::signal(signal, SIG_DFL);
  limit_by_size(size_of(files), files.size());
  try {
    for (const Rehearsal& file : files) rehearse_to(to, file.read);
  } catch (...) {
    // a missing answer reports the failure
  }
  ::_exit(0);
}

/// Parses an answer of the child other than `good`.
Objection objection_in(const std::string& answers_read, const std::string& otherwise) {
  const std::size_t space = answers_read.find(' ');
  if (space == std::string::npos || answers_read.find_first_not_of("0123456789") != space) {
    return {RefusalReason::damaged, otherwise};
  }
  return {static_cast<RefusalReason>(std::stoi(answers_read)), answers_read.substr(space + 1)};
}

[[noreturn]] void fail(const char* what) {
  throw Error(Exit::failed, std::string("cannot start a process to read artefacts: ") + what +
                                ": " + std::generic_category().message(errno));
}

/// Returns the child's answers, for the files that it reached.
std::vector<std::string> answers_of_child(std::span<const Rehearsal> files) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) fail("pipe");
  const pid_t child = ::fork();
  if (child < 0) {
    ::close(pipe[0]);
    ::close(pipe[1]);
    fail("fork");
  }
  if (child == 0) be_the_child(pipe[1], files);
  ::close(pipe[1]);
  const std::string answers_read = read_all(pipe[0]);
  ::close(pipe[0]);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
  std::vector<std::string> answers;
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = answers_read.find(end_of_answer, begin)) != std::string::npos;
       begin = end + 1) {
    answers.push_back(answers_read.substr(begin, end - begin));
  }
  return answers;
}

std::optional<Objection> objection_to(const Rehearsal& file, const std::string& answer) {
  if (answer == good) return std::nullopt;
  Objection objection = objection_in(answer, file.otherwise);
  const bool may_be_for_memory = objection.reason != RefusalReason::wrong_kind;
  if (may_be_for_memory && is_short_of_memory(file.size)) throw std::bad_alloc();
  return objection;
}

}  // namespace

std::optional<Objection> rehearse(std::size_t size, const std::string& otherwise,
                                  const std::function<void()>& read) {
  const Rehearsal file{size, otherwise, read};
  const std::vector<std::string> answers = answers_of_child({&file, 1});
  return objection_to(file, answers.empty() ? "" : answers.front());
}

std::vector<std::optional<Objection>> rehearse_all(std::span<const Rehearsal> files) {
  std::vector<std::optional<Objection>> objections;
  while (objections.size() < files.size()) {
    const auto left = files.subspan(objections.size());
    const std::vector<std::string> answers = answers_of_child(left);
    for (std::size_t i = 0; i < std::min(answers.size(), left.size()); ++i) {
      objections.push_back(objection_to(left[i], answers[i]));
    }
    if (answers.size() >= left.size()) break;
    const Rehearsal& harmful = left[answers.size()];
    objections.push_back(rehearse(harmful.size, harmful.otherwise, harmful.read));
  }
  return objections;
}

}  // namespace piae::artefact
