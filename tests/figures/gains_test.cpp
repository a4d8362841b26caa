#include "figures/gains.hpp"

#include "base/error.hpp"
#include "figures/stored_source.hpp"
#include "support/errors.hpp"
#include "support/published_tables.hpp"

namespace piae::figures {
namespace {

using Gains = StoredSource;

TEST_F(Gains, AreAccuraciesMinusThoseOfTheSameSeedWithoutGeneratedWindows) {
  add_all();  // none: 60 and 65; vae: 75 and 75 at 10to1, 85 and 95 at 2to1
  Source all = source("none vae", "100to1 10to1 2to1");
  const Numbers gains = gains_of_methods(all, all.accuracies().front());
  EXPECT_EQ(field(gains, "vae,0,10to1,45,0", 5), "15");
  EXPECT_EQ(field(gains, "vae,0,10to1,45,1", 5), "10");
  EXPECT_EQ(field(gains, "vae,0,10to1,45,mean", 5), "12.5");
  EXPECT_EQ(field(gains, "vae,0,2to1,145,mean", 5), "27.5");
}

TEST_F(Gains, HaveAnIntervalForThreeSeedsOrMore) {
  add_all();
  Source two = source("none vae", "100to1 10to1");
  EXPECT_EQ(field(gains_of_methods(two, two.accuracies().front()), "vae,0,10to1,45,mean", 6), "");
  add(diagnosis("none", "100to1", 0, 2, 14));  // 70 %
  add(diagnosis("vae", "10to1", 45, 2, 18));   // 90 %: gains 15, 10 and 20
  Source three = source("none vae", "100to1 10to1", "0 1 2");
  const Numbers gains = gains_of_methods(three, three.accuracies().front());
  // 15 -+ 4.30265 * 5 / sqrt(3), Student's t with two degrees of freedom.
  EXPECT_EQ(field(gains, "vae,0,10to1,45,mean", 6), "2.57931");
  EXPECT_EQ(field(gains, "vae,0,10to1,45,mean", 7), "27.4207");
}

TEST_F(Gains, NameTheSourceOfPublishedGains) {
  add_all();
  write_published_tables(folder_);
  Source all{layout_, grid("none vae", "100to1 10to1 2to1"), report::Published(folder_.path())};
  const Numbers gains = gains_of_methods(all, all.accuracies().front());
  EXPECT_EQ(field(gains, "vae,0,2to1,145,mean", 8), "29.4");
  EXPECT_EQ(field(gains, "vae,0,2to1,145,mean", 9), "CWRU");
  EXPECT_EQ(field(gains, "vae,0,10to1,45,mean", 9), "");
}

TEST_F(Gains, MarkACeiling) {
  add_baseline();
  add_method("vae");
  for (const int seed : {0, 1}) add(diagnosis("oracle", "10to1", 45, seed, 20));
  Source all = source("none vae oracle", "100to1 10to1");
  EXPECT_EQ(field(gains_of_methods(all, all.accuracies().front()), "oracle,1,10to1,45,mean", 5),
            "37.5");
}

TEST_F(Gains, NeedAnAblationForTheModels) {
  add_all();
  Source all = source("none vae", "100to1 10to1");
  EXPECT_ERROR(gains_of_models(all, all.accuracies().front()), Exit::input_missing, "ablation");
}

// Numbers without rows cannot be drawn.
TEST_F(Gains, NeedAMethodThatIsNotAnAblation) {
  add_baseline();
  for (const int seed : {0, 1}) add(diagnosis("ae", "10to1", 45, seed, 15));
  Source all = source("none ae", "100to1 10to1");
  EXPECT_ERROR(gains_of_methods(all, all.accuracies().front()), Exit::input_missing, "no method");
}

TEST_F(Gains, NameTheFirstMissingCell) {
  add_all();
  std::filesystem::remove(layout_.diagnosis("vae", "2to1", 1));
  Source all = source("none vae", "100to1 10to1 2to1");
  EXPECT_ERROR(gains_of_methods(all, all.accuracies().front()), Exit::input_missing,
               "method vae, ratio 2to1, seed 1");
}

TEST_F(Gains, AccuraciesIncludeTheBaseline) {
  add_all();
  Source all = source("none vae", "100to1 10to1");
  const Numbers rows = accuracies(all, all.accuracies().front());
  EXPECT_EQ(field(rows, "none,0,100to1,0,0", 5), "60");
  EXPECT_EQ(field(rows, "vae,0,10to1,45,mean", 5), "75");
}

// The baseline that a method must exceed, with the name of its classifier.
TEST_F(Gains, AccuraciesIncludeNearestIfItIsKnown) {
  add_all();
  for (const int seed : {0, 1}) add(by("nearest", diagnosis("none", "100to1", 0, seed, 19)));
  Source all = source("none vae", "100to1 10to1");
  EXPECT_EQ(all.accuracies().size(), 1U);
  const Numbers rows = accuracies(all, all.accuracies().front());
  EXPECT_EQ(field(rows, "nearest,0,100to1,0,mean", 5), "95");
  EXPECT_EQ(field(gains_of_methods(all, all.accuracies().front()), "nearest", 5), "no row");
}

TEST_F(Gains, AreSeparateForEachClassifier) {
  add_all();
  for (const int seed : {0, 1}) {
    add(by("wdcnn-spectrum", diagnosis("none", "100to1", 0, seed, 18)));
    add(by("wdcnn-spectrum", diagnosis("vae", "10to1", 45, seed, 19)));
  }
  Source all = source("none vae", "100to1 10to1");
  ASSERT_EQ(all.accuracies().size(), 2U);
  EXPECT_EQ(field(gains_of_methods(all, all.accuracies()[0]), "vae,0,10to1,45,mean", 5), "12.5");
  EXPECT_EQ(field(gains_of_methods(all, all.accuracies()[1]), "vae,0,10to1,45,mean", 5), "5");
}

}  // namespace
}  // namespace piae::figures
