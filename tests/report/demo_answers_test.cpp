#include "report/demo_answers.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "report/accuracy_rows.hpp"
#include "support/errors.hpp"

namespace piae::report {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Cells of one method by one classifier, one for each accuracy in percent.
void add(std::vector<run::Diagnosis>& cells, const std::string& method,
         const std::string& classifier, const std::vector<double>& percents,
         std::int64_t generated_per_class = 95) {
  for (std::size_t seed = 0; seed < percents.size(); ++seed) {
    run::Diagnosis cell;
    cell.method = method;
    cell.generated_per_class = method == "none" ? 0 : generated_per_class;
    cell.ratio = std::to_string(cell.generated_per_class);
    cell.classifier = classifier;
    cell.seed = static_cast<std::int64_t>(seed);
    cell.accuracy = percents[seed] / 100;
    cell.known_at = {"1800 rpm"};
    cell.tested_at = {"1200 rpm"};
    cells.push_back(cell);
  }
}

class DemoAnswers : public testing::Test {
 protected:
  DemoAnswers() {
    add(cells_.same_speed, "none", "wdcnn", {74, 75, 74});
    add(cells_.same_speed, "none", "nearest", {100, 100, 100});
    add(cells_.same_speed, "piae-dt", "wdcnn", {74, 74, 69});
    add(cells_.same_speed, "shift", "wdcnn", {99, 97, 98});
    add(cells_.other_speed, "none", "wdcnn-spectra", {63, 59, 75});
    add(cells_.other_speed, "none", "nearest", {51, 56, 58});
    add(cells_.other_speed, "shift", "wdcnn-spectra", {79, 70, 89});
    add(cells_.other_speed, "strike-twin", "wdcnn-spectra", {99, 98, 100});
    add(cells_.no_fault, "none", "exclusion-rule", {100});
    cells_.recording = {.file = "recording.txt", .named = "outer", .correct = true};
  }

  /// Replaces the accuracies of a method.
  static void change(std::vector<run::Diagnosis>& cells, const std::string& method,
                     const std::string& classifier, const std::vector<double>& percents) {
    std::erase_if(cells, [&](const run::Diagnosis& cell) {
      return cell.method == method && cell.classifier == classifier;
    });
    add(cells, method, classifier, percents);
  }

  [[nodiscard]] std::string text() const { return demo_answers(cells_); }

  DemoCells cells_;
};

TEST_F(DemoAnswers, TakeOneLineEach) {
  EXPECT_EQ(text(),
            "Three questions about a simulated bearing (percent correct, 3 seeds):\n\n"
            "1. A few windows of each fault are known. What helps a classifier of waveforms?\n"
            "   shift (74 -> 98 %), not piae-dt (72 %). Spectra do not need help: 100 %.\n"
            "2. Faults are known at 1800 rpm, the machine runs at 1200 rpm. What helps?\n"
            "   strike-twin (66 -> 99 % by wdcnn-spectra); shift reaches 79 %.\n"
            "3. No fault was ever recorded. Can one be diagnosed anyway?\n"
            "   Yes: 100 % correct by exclusion-rule; recording.txt: outer, correct.\n");
}

/// An older demo may have left such cells.
TEST_F(DemoAnswers, LeaveOutCellsWithFewerGeneratedWindows) {
  const std::string before = text();
  add(cells_.same_speed, "shift", "wdcnn", {80, 80}, 45);
  add(cells_.same_speed, "oracle", "wdcnn", {99, 99}, 45);
  EXPECT_EQ(text(), before);
}

TEST_F(DemoAnswers, HaveNoLineBeyond80Characters) {
  add(cells_.same_speed, "piae-dt-phase", "wdcnn", {100, 100, 100});
  std::istringstream lines(text());
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST_F(DemoAnswers, FollowTheNumbers) {
  change(cells_.same_speed, "shift", "wdcnn", {99, 79, 98});  // 4 points in one seed
  EXPECT_THAT(text(), HasSubstr("nothing: 74 % alone, shift (92 %) and piae-dt (72 %)."));
  change(cells_.same_speed, "none", "nearest", {80, 80, 80});
  EXPECT_THAT(text(), HasSubstr("Spectra reach 80 %\n   alone."));
  change(cells_.other_speed, "shift", "wdcnn-spectra", {100, 100, 100});
  EXPECT_THAT(text(), HasSubstr("shift (66 -> 100 % by wdcnn-spectra); strike-twin reaches 99 %."));
  change(cells_.other_speed, "none", "wdcnn-spectra", {99, 99, 99});
  EXPECT_THAT(text(), HasSubstr("nothing: 99 % alone, shift (100 %) and strike-twin (99 %)."));
}

TEST_F(DemoAnswers, DenyADiagnosisThatIsWrongOrSeldomCorrect) {
  cells_.recording.correct = false;
  EXPECT_THAT(text(), HasSubstr("Not reliably: 100 % correct"));
  EXPECT_THAT(text(), HasSubstr("outer, wrong."));
  cells_.recording.correct = true;
  change(cells_.no_fault, "none", "exclusion-rule", {79});
  EXPECT_THAT(text(), HasSubstr("Not reliably: 79 % correct"));
}

TEST_F(DemoAnswers, NeedTheCellsOfAllQuestions) {
  DemoCells some = cells_;
  some.no_fault.clear();
  EXPECT_ERROR(demo_answers(some), Exit::input_missing, "without a known fault");
  some = cells_;
  change(some.other_speed, "none", "wdcnn-spectra", {});
  EXPECT_ERROR(demo_answers(some), Exit::input_missing, "at another speed");
}

TEST(Helps, MeansFivePointsInEverySeed) {
  const AccuracyRow alone = row_with("none", "100to1", {70, 70});
  EXPECT_TRUE(helps(row_with("shift", "10to1", {75, 90}), alone));
  EXPECT_FALSE(helps(row_with("shift", "10to1", {74, 90}), alone));
  EXPECT_FALSE(helps(row_with("shift", "10to1", {90}, 7), alone));  // no seed in common
}

}  // namespace
}  // namespace piae::report
