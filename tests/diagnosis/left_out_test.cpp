#include "diagnosis/left_out.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "diagnosis/sets.hpp"

namespace piae::diagnosis {
namespace {

using signal::WindowSet;

/// Returns the first samples, which identify the toy windows.
std::set<float> first_samples_of(const WindowSet& set) {
  std::set<float> firsts;
  for (std::size_t i = 0; i < set.size(); ++i) firsts.insert(set.window(i)[0]);
  return firsts;
}

/// Records the windows it gets, and returns the first sample as the logit of each class.
class Listening final : public Trained {
 public:
  explicit Listening(std::set<float>& tested) : tested_(tested) {}
  Outputs outputs(const WindowSet& windows, const std::string& /*what*/) override {
    Outputs outputs;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      tested_.insert(windows.window(i)[0]);
      outputs.logits.insert(outputs.logits.end(), 3, windows.window(i)[0]);
    }
    return outputs;
  }
  void write(artefact::Writer& /*writer*/) const override {}

 private:
  std::set<float>& tested_;
};

TEST(LeftOut, EachWindowIsTestedOnceByAClassifierNotTrainedOnIt) {
  WindowSet training = empty_set(4);
  add(training, 0, 3, 100);
  add(training, 1, 2, 200);
  add(training, 2, 1, 300);
  Folds folds;
  folds.tested = {0, 1, 1, 0, 4, Folds::none};
  for (const std::int32_t fold : folds.tested) {
    folds.left_out.emplace_back(5);
    if (fold != Folds::none) folds.left_out.back()[static_cast<std::size_t>(fold)] = true;
  }
  folds.left_out[5][1] = true;  // made of a window predicted there
  std::vector<std::set<float>> trained(5);
  std::vector<std::set<float>> tested(5);
  const LeftOut all = judge_left_out(
      training, folds, [&](const WindowSet& normal, const WindowSet& kept, std::int32_t fold) {
        const auto place = static_cast<std::size_t>(fold);
        trained[place] = first_samples_of(kept);
        std::set<float> healthy = trained[place];
        std::erase_if(healthy, [](float first) { return first >= 200; });
        EXPECT_EQ(first_samples_of(normal), healthy);
        return std::make_unique<Listening>(tested[place]);
      });
  using Firsts = std::set<float>;
  EXPECT_EQ(tested[0], (Firsts{100, 200}));
  EXPECT_EQ(trained[0], (Firsts{101, 102, 201, 300}));
  EXPECT_EQ(tested[1], (Firsts{101, 102}));
  EXPECT_EQ(trained[1], (Firsts{100, 200, 201}));
  EXPECT_EQ(tested[4], (Firsts{201}));
  EXPECT_EQ(trained[4], (Firsts{100, 101, 102, 200, 300}));
  EXPECT_TRUE(trained[2].empty());  // nothing to predict there
  EXPECT_THAT(all.labels, testing::ElementsAre(0, 1, 0, 0, 1));
  EXPECT_THAT(all.logits, testing::ElementsAre(100, 100, 100, 200, 200, 200, 101, 101, 101, 102,
                                               102, 102, 201, 201, 201));
}

}  // namespace
}  // namespace piae::diagnosis
