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

TEST(Rehearsal, HasNothingToSayOfWhatIsGood) {
  EXPECT_FALSE(rehearsed([] {}));
}

TEST(Rehearsal, HandsOnWhatIsRefused) {
  const auto objection = rehearsed(
      [] { throw Refusal(Exit::bad_input, RefusalReason::wrong_kind, "a.h5: is 12 \"windows\""); });
  ASSERT_TRUE(objection);
  EXPECT_EQ(objection->reason, RefusalReason::wrong_kind);
  EXPECT_EQ(objection->line, "a.h5: is 12 \"windows\"");
}

TEST(Rehearsal, SurvivesWhateverBecomesOfTheChild) {
  expect_harm([] { ::raise(SIGSEGV); });
  expect_harm([] { ::raise(SIGKILL); });
  expect_harm([] { std::abort(); });
  expect_harm([] { throw std::runtime_error("odd"); });
  expect_harm([] { ::_exit(0); });  // without having found it good
}

TEST(Rehearsal, GivesTheChildMemoryAndTimeByTheFilesSize) {
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

// A shell's `ulimit -v`: a good file is not damaged because memory is short.
TEST(Rehearsal, DoesNotBlameTheFileWhereMemoryIsShort) {
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

// A shell may have its children ignore this signal: the system then keeps no status of theirs.
TEST(Rehearsal, NeedsNoStatusOfTheChild) {
  const auto before = ::signal(SIGCHLD, SIG_IGN);
  EXPECT_FALSE(rehearsed([] {}));
  expect_harm([] { ::raise(SIGKILL); });
  ::signal(SIGCHLD, before);
}

}  // namespace
}  // namespace piae::artefact
