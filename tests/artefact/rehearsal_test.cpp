#include "artefact/rehearsal.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <new>
#include <vector>

namespace piae::artefact {
namespace {

const std::string otherwise = "a.h5: came to harm";

std::optional<Objection> rehearsed(const std::function<void()>& read) {
  return rehearse(1000, otherwise, read);
}

void expect_harm(const std::function<void()>& read) {
  const auto objection = rehearsed(read);
  ASSERT_TRUE(objection);
  EXPECT_EQ(objection->reason, RefusalReason::damaged);
  EXPECT_EQ(objection->line, otherwise);
}

TEST(Rehearsal, AcceptsValidFiles) {
  EXPECT_FALSE(rehearsed([] {}));
}

TEST(Rehearsal, ReportsRefusals) {
  const auto objection = rehearsed(
      [] { throw Refusal(Exit::bad_input, RefusalReason::wrong_kind, "a.h5: is 12 \"windows\""); });
  ASSERT_TRUE(objection);
  EXPECT_EQ(objection->reason, RefusalReason::wrong_kind);
  EXPECT_EQ(objection->line, "a.h5: is 12 \"windows\"");
}

TEST(Rehearsal, SurvivesAnyEndOfTheChild) {
  expect_harm([] { ::raise(SIGSEGV); });
  expect_harm([] { ::raise(SIGKILL); });
  expect_harm([] { std::abort(); });
  expect_harm([] { throw std::runtime_error("odd"); });
  expect_harm([] { ::_exit(0); });  // ends before an answer
}

/// Rehearses three files, of which the second does `read`.
std::vector<std::optional<Objection>> rehearsed_among_others(const std::function<void()>& read) {
  const std::vector<Rehearsal> files{
      {1000, "first", [] {}},
      {1000, "second", read},
      {1000, "third",
       [] { throw Refusal(Exit::bad_input, RefusalReason::wrong_kind, "third: is odd"); }}};
  return rehearse_all(files);
}

TEST(Rehearsal, FindsTheHarmfulFileAmongMany) {
  const std::vector<std::function<void()>> harms{
      [] { ::raise(SIGSEGV); }, [] { throw std::runtime_error("odd"); }, [] { ::_exit(0); }};
  for (const auto& harm : harms) {
    const auto objections = rehearsed_among_others(harm);
    ASSERT_EQ(objections.size(), 3U);
    EXPECT_FALSE(objections[0]);
    ASSERT_TRUE(objections[1]);
    EXPECT_EQ(objections[1]->reason, RefusalReason::damaged);
    EXPECT_EQ(objections[1]->line, "second");
    ASSERT_TRUE(objections[2]);
    EXPECT_EQ(objections[2]->line, "third: is odd");
  }
  EXPECT_FALSE(rehearsed_among_others([] {})[1]);
  EXPECT_TRUE(rehearse_all({}).empty());
}

TEST(Rehearsal, LimitsMemoryAndTimeByTheFileSize) {
  expect_harm([] {
    std::vector<char> large(std::size_t{1} << 30U);
    static volatile char first = large.front();
    (void)first;
  });
  expect_harm([] {
    for (volatile bool forever = true; forever;) {
    }
  });
}

// A shell's `ulimit -v` must not make good files look damaged.
TEST(Rehearsal, DoesNotRefuseAFileIfMemoryIsShort) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &before), 0);
  const rlimit little{std::size_t{1} << 20U, before.rlim_max};
  ::setrlimit(RLIMIT_AS, &little);
  EXPECT_THROW((void)rehearsed([] { throw std::bad_alloc(); }), std::bad_alloc);
  ::setrlimit(RLIMIT_AS, &before);
  expect_harm([] { throw std::bad_alloc(); });
}

TEST(Rehearsal, LeavesNothingBehind) {
  int value = 1;
  EXPECT_FALSE(rehearsed([&] { value = 2; }));
  EXPECT_EQ(value, 1);
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

// A shell may let its children ignore this signal: the system then does not keep their status.
TEST(Rehearsal, WorksWithoutTheStatusOfTheChild) {
  const auto before = ::signal(SIGCHLD, SIG_IGN);
  EXPECT_FALSE(rehearsed([] {}));
  expect_harm([] { ::raise(SIGKILL); });
  ::signal(SIGCHLD, before);
}

}  // namespace
}  // namespace piae::artefact
