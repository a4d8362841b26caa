#include "figures/confusion.hpp"

#include "figures/diagnosed_windows.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

using testing::HasSubstr;
using testing::Not;

using Confusion = DiagnosedWindows;

TEST_F(Confusion, SumsSeedsInPercentOfEachTrueClass) {
  add_two_seeds();
  Source two = source("vae", "10to1 2to1");
  const Numbers numbers = confusions(two);
  EXPECT_EQ(field(numbers, "vae,0,2to1,Normal,Normal", 5), "3");
  EXPECT_EQ(field(numbers, "vae,0,2to1,Normal,Normal", 6), "75");
  EXPECT_EQ(field(numbers, "vae,0,2to1,Normal,IR", 6), "25");
  EXPECT_EQ(field(numbers, "vae,0,2to1,IR,Normal", 6), "25");
  EXPECT_EQ(field(numbers, "vae,0,2to1,OR,IR", 5), "1");
  EXPECT_EQ(field(numbers, "vae,0,2to1,OR,Normal", 5), "0");
}

TEST_F(Confusion, ShowsTheMostGeneratedWindowsAndNone) {
  add_two_seeds();
  for (const int seed : {0, 1}) add(record_of("none", "100to1", 0, seed, {0, 1}, {0, 0}));
  Source all = source("none vae", "100to1 10to1 2to1");
  const Numbers numbers = confusions(all);
  EXPECT_THAT(numbers.csv(), Not(HasSubstr("10to1")));
  EXPECT_EQ(field(numbers, "none,0,100to1,IR,Normal", 5), "2");
}

TEST_F(Confusion, OmitsAClassWithoutTestWindows) {
  add(record_of("vae", "2to1", 145, 0, {0, 1}, {0, 1}));
  Source one = source("vae", "2to1", "0");
  EXPECT_THAT(confusions(one).csv(), Not(HasSubstr(",OR,Normal")));
}

/// A picture without cells cannot be drawn.
TEST_F(Confusion, IsLeftOutWithoutACellByThePapersClassifier) {
  add(by("nearest", diagnosis("none", "100to1", 0, 0, 12)));
  Source one{layout_, {.dataset = "cwru", .scored = {}, .combinations = {}, .seeds = {}}, {}};
  EXPECT_THROW(confusions(one), LeftOut);
}

TEST_F(Confusion, NamesAMissingDiagnosis) {
  add_two_seeds();
  std::filesystem::remove(layout_.diagnosis("vae", "2to1", 1));
  Source two = source("vae", "10to1 2to1");
  EXPECT_ERROR(confusions(two), Exit::input_missing, "seed1/vae/2to1/wdcnn/diagnosis.h5");
}

TEST_F(Confusion, RefusesOtherClassesOrAnotherSplit) {
  add_two_seeds();
  Source two = source("vae", "2to1");
  scoring::DiagnosisRecord other = record_of("vae", "2to1", 145, 1, {0, 1}, {0, 1});
  other.info.classes[1].name = "ball";
  add(other);
  EXPECT_ERROR(confusions(two), Exit::bad_input, "seed1/vae/2to1/wdcnn/diagnosis.h5: its classes");
  other = record_of("vae", "2to1", 145, 1, {0, 1}, {0, 1});
  other.protocol = signal::Protocol::blocked;
  add(other);
  EXPECT_ERROR(confusions(two), Exit::bad_input, "seed1/vae/2to1/wdcnn/diagnosis.h5: its classes");
}

}  // namespace
}  // namespace piae::figures
