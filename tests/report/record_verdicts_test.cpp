#include "report/record_verdicts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/stored_verdicts.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::report {
namespace {

using classification::classifier_of_toys;
using testing::ElementsAre;
using testing::HasSubstr;

/// Two seeds of a classifier on four records: a healthy one, and a-1, a-2 and b-1, of which seed 0
/// takes a-2 and seed 1 takes b-1 for another class.
class VerdictsOnRecords : public testing::Test {
 protected:
  VerdictsOnRecords() {
    const signal::DatasetInfo info = classifier_of_toys().info();
    for (std::size_t i = 0; i < names_.size(); ++i) names_[i] = info.classes[i].name;
    run::store_verdicts(layout_, 0, {0, 1, 2, 2});
    run::store_verdicts(layout_, 1, {0, 1, 1, 1});
  }

  [[nodiscard]] RecordVerdicts verdicts(const std::string& others = "",
                                        std::vector<std::int64_t> seeds = {0, 1}) const {
    const run::Grid grid{.dataset = "toys",
                         .scored = {},
                         .combinations = {{"none", "100to1", "nearest"}},
                         .seeds = std::move(seeds)};
    return record_verdicts(layout_, grid, others.empty() ? "" : folder_.write("o.csv", others));
  }

  std::vector<std::string> names_ = std::vector<std::string>(3);
  Folder folder_;
  run::Layout layout_{folder_.path(), "toys"};
  const std::string graded_ = "record,grade,Ann\na-1,Y2,right\na-2,N1,wrong\nb-1,Y1,right\n";
};

TEST_F(VerdictsOnRecords, AreRightIfTheClassIsTheDescribedOne) {
  const RecordVerdicts all = verdicts();
  ASSERT_EQ(all.judges.size(), 1U);
  EXPECT_EQ(all.judges[0].name, "nearest");
  EXPECT_THAT(all.judges[0].right, ElementsAre(ElementsAre(true, true, false, true),
                                               ElementsAre(true, true, true, false)));
  EXPECT_DOUBLE_EQ(all.judges[0].count_right({1, 2, 3}), 2);  // (2 + 2) / 2
  EXPECT_DOUBLE_EQ(all.judges[0].count_right({2}), 0.5);
  EXPECT_FALSE(all.records[0].is_faulty);
  EXPECT_TRUE(all.records[3].is_faulty);
}

TEST_F(VerdictsOnRecords, AreCountedByTheLetterOfGrades) {
  const std::string text = markdown(verdicts_document(verdicts(graded_, {0})));
  EXPECT_THAT(text, HasSubstr("| judge   | Y1, Y2 (2) | N1 (1) | all faults (3) |"));
  EXPECT_THAT(text, HasSubstr("| Ann     |          2 |      0 |              2 |"));
  EXPECT_THAT(text, HasSubstr("| nearest |          2 |      0 |              2 |"));
}

TEST_F(VerdictsOnRecords, AreMeansOverSeveralSeeds) {
  const std::string text = markdown(verdicts_document(verdicts(graded_)));
  EXPECT_THAT(text, HasSubstr("| Ann     |          2 |      0 |              2 |"));
  EXPECT_THAT(text, HasSubstr("| nearest |        1.5 |    0.5 |            2.0 |"));
  EXPECT_THAT(text, HasSubstr("right 1/2"));
}

TEST_F(VerdictsOnRecords, AreNotCountedByGradeWithoutGrades) {
  const Document document = verdicts_document(verdicts());
  EXPECT_EQ(document.sections.front().key, "by-class");
}

TEST_F(VerdictsOnRecords, ShowTheWronglyNamedClass) {
  const text::Table table = verdicts_document(verdicts(graded_, {0})).sections.back().table;
  EXPECT_EQ(table.rows()[0].cells[3].text, "–");  // Ann did not judge the healthy record
  EXPECT_EQ(table.rows()[1].cells[4].text, "right");
  EXPECT_EQ(table.rows()[2].cells[3].text, "wrong");
  EXPECT_EQ(table.rows()[2].cells[4].text, names_[2]);
}

TEST_F(VerdictsOnRecords, AreWrittenAsCsvWithoutFurtherCommas) {
  const std::string csv = verdicts_csv(verdicts(graded_, {0}));
  EXPECT_THAT(csv, testing::StartsWith("dataset,judge,method,classifier,ratio,seed,record,class,"
                                       "faulty,grade,named,right,share,evidence\n"));
  EXPECT_THAT(csv, HasSubstr("\ntoys,Ann,Ann,,,,a-2," + names_[1] + ",1,N1,,0,,\n"));
  EXPECT_THAT(csv, HasSubstr("\ntoys,nearest,none,nearest,100to1,0,a-2," + names_[1] + ",1,N1," +
                             names_[2] + ",0,1.0000,"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 3 + 4);
  EXPECT_EQ(std::ranges::count(csv, ','), 8 * 13);
  EXPECT_EQ(std::ranges::count(csv, '"'), 0);
}

TEST_F(VerdictsOnRecords, OfOthersMustNameEachFaultyRecordOnce) {
  EXPECT_ERROR(verdicts("record,grade\na-1,Y1\na-2,Y1\n"), Exit::bad_input,
               "o.csv: lacks a line for record 'b-1'");
  EXPECT_ERROR(verdicts(graded_ + "a-1,Y1,right\n"), Exit::bad_input,
               "o.csv, line 5: names record 'a-1' again");
  EXPECT_ERROR(verdicts(graded_ + "c-1,Y1,right\n"), Exit::bad_input,
               "line 5: names an unknown record, 'c-1'");
  EXPECT_ERROR(verdicts("record,grade,Ann\na-1,Y1,yes\n"), Exit::bad_input,
               "line 2: 'yes' must be right or wrong");
  EXPECT_ERROR(verdicts("grade,record\nY1,a-1\n"), Exit::bad_input,
               "the header must begin with record,grade");
}

}  // namespace
}  // namespace piae::report
