#include "figures/reliability.hpp"

#include "figures/diagnosed_windows.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

class ReliabilityFigure : public DiagnosedWindows {
 protected:
  /// Adds two windows, predicted with scores of 0.95 and 0.55.
  void add_seed(int seed, bool first_is_right, bool second_is_right) const {
    scoring::DiagnosisRecord record = record_of("vae", "2to1", 145, seed, {1, 2},
                                                {first_is_right ? 1 : 2, second_is_right ? 2 : 1});
    record.scores = {0.02F, 0.03F, 0.03F, 0.25F, 0.2F, 0.2F};
    record.scores[index_of(record.predictions[0])] = 0.95F;
    record.scores[3 + index_of(record.predictions[1])] = 0.55F;
    add(record);
  }
  static Numbers numbers_of(Source& source) {
    return reliabilities(source, source.accuracies().front());
  }
};

/// Over both seeds half of each bin is correct: 0.95 and 0.55 are off by 45 and 5 points.
TEST_F(ReliabilityFigure, PoolsTheSeeds) {
  add_seed(0, true, false);
  add_seed(1, false, true);
  Source two = source("vae", "2to1");
  const Numbers numbers = numbers_of(two);
  const std::string top = "vae,0,2to1,bin,90,100";
  EXPECT_EQ(field(numbers, top, 6), "2");
  EXPECT_EQ(field(numbers, top, 7), "50");
  EXPECT_EQ(field(numbers, top, 8), "95");
  EXPECT_EQ(field(numbers, top, 9), "50");
  EXPECT_EQ(field(numbers, top, 10), "45");
  EXPECT_EQ(field(numbers, "vae,0,2to1,bin,50,60", 10), "5");
  EXPECT_EQ(field(numbers, "vae,0,2to1,all,0,100", 6), "4");
  EXPECT_EQ(field(numbers, "vae,0,2to1,all,0,100", 9), "50");
  EXPECT_EQ(field(numbers, "vae,0,2to1,all,0,100", 10), "25");
}

TEST_F(ReliabilityFigure, OmitsAnEmptyBin) {
  add_seed(0, true, true);
  Source one = source("vae", "2to1", "0");
  const Numbers numbers = numbers_of(one);
  EXPECT_EQ(field(numbers, "vae,0,2to1,bin,0,10", 7), "0");
  EXPECT_EQ(field(numbers, "vae,0,2to1,bin,0,10", 9), "");
}

TEST_F(ReliabilityFigure, NamesAMissingDiagnosis) {
  Source one = source("vae", "2to1", "0");
  EXPECT_ERROR(numbers_of(one), Exit::input_missing, "seed0/vae/2to1/wdcnn/diagnosis.h5");
}

TEST_F(ReliabilityFigure, IsLeftOutForAClassifierWithoutConfidence) {
  add_seed(0, true, false);
  scoring::DiagnosisRecord votes = by("nearest", record_of("vae", "2to1", 145, 0, {1, 1}, {1, 2}));
  for (std::size_t i = 0; i < 2; ++i) votes.scores[3 * i + index_of(votes.predictions[i])] = 1;
  add(votes);
  Source one = source("vae", "2to1", "0");
  const report::ClassifierRows& by_votes = one.accuracies().back();
  ASSERT_EQ(by_votes.classifier, "nearest");
  EXPECT_THROW((void)reliabilities(one, by_votes), LeftOut);
}

}  // namespace
}  // namespace piae::figures
