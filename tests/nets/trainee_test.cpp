#include "nets/trainee.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "support/folder.hpp"

namespace piae::nets {
namespace {

/// Trains nothing, in epochs much shorter than the time between two checkpoints.
class ShortEpochs : public Trainee {
 public:
  explicit ShortEpochs(const std::filesystem::path& checkpoint) : checkpoint_(checkpoint) {}

  [[nodiscard]] std::size_t epochs() const override { return 40; }
  std::string run_epoch(std::size_t) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (std::filesystem::exists(checkpoint_)) ++epochs_with_a_checkpoint_;
    return "";
  }
  void write_state(artefact::Writer&) const override {}
  void read_state(const artefact::Reader&) override {}

  [[nodiscard]] std::size_t epochs_with_a_checkpoint() const { return epochs_with_a_checkpoint_; }

 private:
  std::filesystem::path checkpoint_;
  std::size_t epochs_with_a_checkpoint_ = 0;
};

/// A kill -9 costs at most the interval, however short the epochs are.
TEST(RunEpochs, SavesACheckpointAtIntervalsThatSpanManyEpochs) {
  const Folder folder;
  ShortEpochs trainee(folder / "model.checkpoint");
  run_epochs(trainee, {.path = folder / "model.checkpoint",
                       .provenance = {"tester", "", {}},
                       .interval_s = 0.05,
                       .interrupted = [] { return false; }});
  EXPECT_GT(trainee.epochs_with_a_checkpoint(), 0);
  EXPECT_LT(trainee.epochs_with_a_checkpoint(), trainee.epochs());
}

}  // namespace
}  // namespace piae::nets
