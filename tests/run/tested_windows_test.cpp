#include "run/tested_windows.hpp"

#include "run/held.hpp"
#include "support/errors.hpp"
#include "support/stored_run.hpp"
#include "support/stored_tested_windows.hpp"

namespace piae::run {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TestedWindowsOfARun : public StoredRun {
 protected:
  [[nodiscard]] Results results(const std::vector<std::string>& leave_out = {}) const {
    return collect_held(layout_, grid("none", "100to1", "0"), Held(layout_, leave_out)).results;
  }
};

TEST_F(TestedWindowsOfARun, GiveTheirRecords) {
  save_tested_windows(layout_, "cwru", 3, {1, 2}, {{1, 0}, {500, 0}});
  const TestedWindows windows =
      read_tested_windows(artefact::Reader(layout_.windows("A", 3), "windows"), "cwru", 3);
  EXPECT_THAT(windows.labels, ElementsAre(1, 2));
  EXPECT_THAT(windows.places.record, ElementsAre(1, 0));
  EXPECT_THAT(windows.places.first_sample, ElementsAre(500, 0));
}

TEST_F(TestedWindowsOfARun, AreRefusedInTheWrongPlace) {
  save_tested_windows(layout_, "cwru", 3, {1, 2}, {{1, 0}, {500, 0}});
  const artefact::Reader reader(layout_.windows("A", 3), "windows");
  EXPECT_ERROR(read_tested_windows(reader, "hit-sm", 3), Exit::bad_input, "data set is cwru");
  EXPECT_ERROR(read_tested_windows(reader, "cwru", 4), Exit::bad_input, "seed is 3");
  save_tested_windows(layout_, "cwru", 3, {1, 2}, {{1}, {500, 0}});
  EXPECT_ERROR(read_tested_windows(artefact::Reader(layout_.windows("A", 3), "windows"), "cwru", 3),
               Exit::bad_input, "/record/index");
}

/// 20 windows of class 1 in one record. The first twelve are recognised, with matching scores: one
/// of two decisions over ten windows is right, and a decision over 60 windows does not exist.
TEST_F(TestedWindowsOfARun, GiveDecisions) {
  scoring::DiagnosisRecord record = diagnosis("none", "100to1", 0, 0, 12);
  for (std::size_t i = 0; i < 20; ++i) record.scores[3 * i + index_of(record.predictions[i])] = 1;
  add(record);
  EXPECT_THAT(results().diagnoses.at(0).decisions, IsEmpty()) << "no A.h5";
  save_tested_windows(layout_, "cwru", 0, record.labels, one_record(20));
  const auto decisions = results().diagnoses.at(0).decisions;
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_EQ(decisions[0].accuracy, 0.6);
  EXPECT_EQ(decisions[1].decisions, 2U);
  EXPECT_EQ(decisions[1].accuracy, 0.5);
  EXPECT_THAT(results({"seed0/A.h5"}).diagnoses.at(0).decisions, IsEmpty()) << "out of date";
}

TEST_F(TestedWindowsOfARun, AreAProblemOfTheCellThatUsedOthers) {
  add(diagnosis("none", "100to1", 0, 0, 12));
  save_tested_windows(layout_, "cwru", 0, std::vector<Label>(20, 2), one_record(20));
  const Results found = results();
  EXPECT_THAT(found.problems,
              ElementsAre(testing::AllOf(testing::StartsWith("method none, ratio 100to1, seed 0: "),
                                         HasSubstr("diagnosis.h5: /labels are not those of A.h5"),
                                         testing::Not(HasSubstr("\n")))));
  EXPECT_EQ(found.exit, Exit::bad_input);
}

TEST_F(TestedWindowsOfARun, AreOneProblemIfDamaged) {
  add(diagnosis("none", "100to1", 0, 0, 12));
  add(by("nearest", diagnosis("none", "100to1", 0, 0, 12)));
  save_tested_windows(layout_, "cwru", 0, std::vector<Label>(20, 1), one_record(20));
  std::filesystem::resize_file(layout_.windows("A", 0), 1000);
  const Results found = results();
  EXPECT_THAT(found.problems,
              ElementsAre(testing::AllOf(testing::StartsWith("test windows, seed 0: "),
                                         HasSubstr("seed0/A.h5"))));
  EXPECT_EQ(found.diagnoses.size(), 2U);
}

}  // namespace
}  // namespace piae::run
