#include "figures/refusal.hpp"

#include "figures/diagnosed_windows.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

class RefusalFigure : public DiagnosedWindows {
 protected:
  /// Adds four windows by falling score, the last two with the same.
  void add_seed(const std::string& method, const std::string& ratio, int generated, int seed,
                const std::vector<bool>& right) const {
    std::vector<Label> predictions;
    for (const bool is_right : right) predictions.push_back(is_right ? 1 : 2);
    scoring::DiagnosisRecord record =
        record_of(method, ratio, generated, seed, {1, 1, 1, 1}, predictions);
    const std::vector<float> scores{0.9F, 0.8F, 0.7F, 0.7F};
    for (std::size_t i = 0; i < 4; ++i) {
      record.scores[3 * i + index_of(predictions[i])] = scores[i];
    }
    add(record);
  }
  static Numbers numbers_of(Source& source) {
    return refusals(source, source.accuracies().front());
  }
};

/// At two windows 2 and 1 are correct, at four 3 and 1. The last two windows have the same score,
/// so three windows count 2.5 and 1 correct ones.
TEST_F(RefusalFigure, IsTheMeanOverTheSeedsAtEachPercent) {
  add_seed("vae", "2to1", 145, 0, {true, true, true, false});
  add_seed("vae", "2to1", 145, 1, {true, false, false, false});
  add_seed("vae", "10to1", 45, 0, {false, false, false, false});
  Source two = source("vae", "2to1");
  const Numbers numbers = numbers_of(two);
  EXPECT_EQ(field(numbers, "vae,0,2to1,1", 4), "100");
  EXPECT_EQ(field(numbers, "vae,0,2to1,25", 4), "100");
  EXPECT_EQ(field(numbers, "vae,0,2to1,50", 4), "75");
  EXPECT_EQ(field(numbers, "vae,0,2to1,75", 4), "58.3333");  // mean of 2.5/3 and 1/3
  EXPECT_EQ(field(numbers, "vae,0,2to1,100", 4), "50");
  EXPECT_EQ(numbers.csv().find("10to1"), std::string::npos);
}

TEST_F(RefusalFigure, ShowsNearestAsAHorizontalLine) {
  add_seed("none", "100to1", 0, 0, {true, false, true, false});
  scoring::DiagnosisRecord votes =
      by("nearest", record_of("none", "100to1", 0, 0, {1, 1, 1, 1}, {1, 1, 2, 1}));
  for (std::size_t i = 0; i < 4; ++i) votes.scores[3 * i + index_of(votes.predictions[i])] = 1;
  add(votes);
  Source one = source("none", "100to1", "0");
  const Numbers numbers = numbers_of(one);
  EXPECT_EQ(field(numbers, "none,0,100to1,25", 4), "100");
  EXPECT_EQ(field(numbers, "none,0,100to1,50", 4), "50");
  for (const char* share : {"1", "33", "100"}) {
    EXPECT_EQ(field(numbers, std::string("nearest,0,100to1,") + share, 4), "75");
  }
}

}  // namespace
}  // namespace piae::figures
