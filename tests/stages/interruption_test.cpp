#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

#include "stages/tiny.hpp"

/// Stages that are interrupted at any moment.
namespace piae::stages {
namespace {

class Interruption : public testing::Test {
 protected:
  void SetUp() override {
    tiny_.run_chain_before("train");
    ASSERT_EQ(tiny_.run("train", to("uncut.h5")).status, 0);
  }

  [[nodiscard]] static Arguments to(const std::string& model) {
    return with(with(step_of("train").arguments, "--epochs", "120"), "--output", model);
  }

  /// Expects that a file under its final name is complete.
  void expect_nothing_or_good(const std::string& file) const {
    if (!fs::exists(tiny_ / file)) return;
    const Outcome verified = tiny_.run("verify", {file});
    EXPECT_EQ(verified.status, 0) << verified.out;
  }
  void expect_finished_as_uncut() const {
    const Outcome outcome = tiny_.run("train", to("cut.h5"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(bytes_of(tiny_ / "cut.h5") == bytes_of(tiny_ / "uncut.h5"));
    EXPECT_FALSE(fs::exists(tiny_ / "cut.h5.checkpoint"));
    EXPECT_EQ(tiny_.left_overs(), std::set<std::string>());
  }

  /// Expects that neither a damaged checkpoint nor one of another seed is used: training restarts.
  void expect_useless_checkpoints_are_not_used(const std::string& checkpoint) const {
    std::string damaged = checkpoint;
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
    write_bytes(tiny_ / "cut.h5.checkpoint", damaged);
    expect_finished_as_uncut();

    write_bytes(tiny_ / "other.h5.checkpoint", checkpoint);
    const Arguments other = with(with(to("other.h5"), "--epochs", "4"), "--seed", "1");
    const Outcome outcome = tiny_.run("train", other);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("starts again"), std::string::npos) << outcome.err;
    ASSERT_EQ(tiny_.run("train", with(other, "--output", "fresh.h5")).status, 0);
    EXPECT_TRUE(bytes_of(tiny_ / "other.h5") == bytes_of(tiny_ / "fresh.h5"));
  }

  Tiny tiny_;
  std::mt19937 random_{17};
};

TEST_F(Interruption, SigtermLeavesACheckpointToContinueFrom) {
  for (int cut = 0; cut < 2; ++cut) {
    Process train(tiny_.path(), "train", to("cut.h5"));
    train.wait_until_it_catches_sigterm();
    train.send(SIGTERM);
    const Outcome outcome = train.wait();
    ASSERT_EQ(outcome.status, 75) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("train: interrupted after epoch"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("cut.h5.checkpoint"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("going on from") != std::string::npos, cut > 0) << outcome.err;
    EXPECT_FALSE(fs::exists(tiny_ / "cut.h5"));
    ASSERT_TRUE(fs::exists(tiny_ / "cut.h5.checkpoint"));
    expect_nothing_or_good("cut.h5.checkpoint");
  }
  const std::string checkpoint = bytes_of(tiny_ / "cut.h5.checkpoint");
  expect_finished_as_uncut();
  fs::remove(tiny_ / "cut.h5");
  expect_useless_checkpoints_are_not_used(checkpoint);
}

/// srun forwards USR1; closing a terminal sends HUP.
TEST_F(Interruption, OtherSignalsActLikeSigterm) {
  for (const int signal : {SIGUSR1, SIGHUP, SIGINT}) {
    Process train(tiny_.path(), "train", to("cut.h5"));
    train.wait_until_it_catches_sigterm();
    train.send(signal);
    const Outcome outcome = train.wait();
    EXPECT_EQ(outcome.status, 75) << "signal " << signal << ": " << outcome.err;
    EXPECT_TRUE(fs::exists(tiny_ / "cut.h5.checkpoint"));
  }
  expect_finished_as_uncut();
}

TEST_F(Interruption, RightAfterTheStartLeavesACheckpoint) {
  expect_checkpoints_at_once(tiny_, to("cut.h5"));
  expect_finished_as_uncut();
}

TEST_F(Interruption, KilledTrainingLeavesNoPartialFile) {
  for (int cut = 0; cut < 5; ++cut) {
    Process train(tiny_.path(), "train", to("cut.h5"));
    train.wait_until_it_catches_sigterm();
    std::this_thread::sleep_for(std::chrono::milliseconds(random_() % 30));
    train.send(SIGTERM);  // so that the kill comes near the checkpoint
    std::this_thread::sleep_for(std::chrono::microseconds(random_() % 8000));
    train.send(SIGKILL);
    const int status = train.wait().status;
    EXPECT_TRUE(status == 128 + SIGKILL || status == 75) << status;
    expect_nothing_or_good("cut.h5");
    expect_nothing_or_good("cut.h5.checkpoint");
  }
  expect_finished_as_uncut();
}

TEST(Killed, SplitLeavesNoPartialFile) {
  const Tiny tiny;
  tiny.run_chain_before("train");
  const Arguments arguments = with(step_of("split").arguments, "--output-dir", "cut");
  std::mt19937 random(5);
  for (int cut = 0; cut < 12; ++cut) {
    Process split(tiny.path(), "split", arguments);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 40000));
    split.send(SIGKILL);
    (void)split.wait();
    for (const std::string& role : step_of("split").outputs) {
      const std::string file = "cut/" + role;
      if (!fs::exists(tiny / file)) continue;
      EXPECT_EQ(tiny.run("verify", {file}).status, 0) << file;
    }
  }
  ASSERT_EQ(tiny.run("split", arguments).status, 0);
  for (const std::string& role : step_of("split").outputs) {
    EXPECT_TRUE(bytes_of(tiny / role) == bytes_of(tiny / ("cut/" + role)));
  }
  EXPECT_EQ(tiny.left_overs(), std::set<std::string>());
}

}  // namespace
}  // namespace piae::stages
