#include <gmock/gmock.h>

#include <fstream>

#include "base/error.hpp"
#include "report/paper.hpp"
#include "support/published_tables.hpp"

namespace piae::report {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;

class PublishedTables : public testing::Test {
 protected:
  PublishedTables() {
    write(baseline_, "# comment\ndataset,run1,run2,average\ncwru,61.8,62.0,61.9\n");
    write(methods_, "dataset,method,50to1,1to1\ncwru,vae,78.0,95.8\ncwru,piae-dt,80.0,97.6\n");
    write(ablation_, "dataset,model,50to1,1to1\ncwru,model1,80,97.6\n\ncwru,model2,79.2,97.5\n");
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
  }
  void expect_refused(const std::string& name, const std::string& text, const std::string& what) {
    write(name, text);
    try {
      Published published(folder_.path());
      ADD_FAILURE() << "not refused: " << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::bad_input);
      EXPECT_THAT(error.what(), EndsWith(name + what));
    }
  }

  Folder folder_;
  const std::string baseline_ = published_baseline;
  const std::string methods_ = published_methods;
  const std::string ablation_ = published_ablation;
};

TEST_F(PublishedTables, AreLookedUpByTheNamesOfTheGrid) {
  const Published published(folder_.path());
  EXPECT_EQ(published.percent("cwru", "none", "100to1"), 61.9);
  EXPECT_EQ(published.percent("cwru", "vae", "50to1"), 78.0);
  EXPECT_EQ(published.percent("cwru", "piae-dt", "1to1"), 97.6);
  EXPECT_EQ(published.percent("cwru", "ae", "50to1"), 79.2);
  EXPECT_THAT(published.baseline_runs("cwru"), ElementsAre(61.8, 62.0));
}

TEST_F(PublishedTables, HaveNoValueThatThePaperLacks) {
  const Published published(folder_.path());
  EXPECT_EQ(published.percent("hit-sm", "none", "100to1"), std::nullopt);
  EXPECT_EQ(published.percent("cwru", "none", "1to1"), std::nullopt);
  EXPECT_EQ(published.percent("cwru", "vae", "25to1"), std::nullopt);
  EXPECT_THAT(published.baseline_runs("hit-sm"), IsEmpty());
}

TEST_F(PublishedTables, NameAMissingFile) {
  std::filesystem::remove(folder_.path() / methods_);
  try {
    Published published(folder_.path());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::input_missing);
    EXPECT_THAT(error.what(), testing::HasSubstr(methods_));
  }
}

TEST_F(PublishedTables, RefuseNumbersThatAreNotPercentages) {
  for (const std::string number : {"x", "", "80.0x", "-1", "100.1", "nan", "inf", " 80"}) {
    expect_refused(methods_, "dataset,method,50to1\n# c\ncwru,vae," + number + "\n",
                   ", line 3: '" + number + "' is not a percentage");
  }
}

TEST_F(PublishedTables, RefuseRowsOfAnotherLength) {
  expect_refused(methods_, "dataset,method,50to1\ncwru,vae\n",
                 ", line 2: has 2 fields, but the header has 3");
}

TEST_F(PublishedTables, RefuseAnUnknownHeader) {
  expect_refused(methods_, "dataset,model,50to1\ncwru,vae,1\n",
                 ", line 1: field 2 of the header must be 'method'");
  expect_refused(methods_, "dataset\ncwru\n", ", line 1: field 2 of the header must be 'method'");
  expect_refused(methods_, "dataset,method,51to1\ncwru,vae,1\n",
                 ", line 1: unknown ratio '51to1'; known: 100to1, 50to1, 25to1, 10to1, 5to1, "
                 "2to1, 1to1");
}

TEST_F(PublishedTables, RefuseAnUnknownBaselineHeader) {
  expect_refused(baseline_, "dataset,run2,average\ncwru,1,1\n",
                 ", line 1: field 2 of the header must be 'run1'");
}

TEST_F(PublishedTables, RefuseAnUnknownModel) {
  expect_refused(ablation_, "dataset,model,50to1\ncwru,model6,1\n",
                 ", line 2: unknown model 'model6'; known are model1 to model5");
}

TEST_F(PublishedTables, RefuseContradictingFigures) {
  expect_refused(ablation_, "dataset,model,50to1\ncwru,model1,81\n",
                 ", line 2: contradicts the figure for piae-dt at 50to1 in " +
                     (folder_ / methods_).string() + ", line 3");
}

TEST_F(PublishedTables, RefuseADatasetTwice) {
  expect_refused(baseline_, "dataset,run1,average\ncwru,1,1\ncwru,1,1\n",
                 ", line 3: names data set cwru again");
}

TEST_F(PublishedTables, RefuseAFileWithoutATable) {
  expect_refused(baseline_, "# nothing\n", ": holds no table");
}

}  // namespace
}  // namespace piae::report
