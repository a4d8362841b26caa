#include <gmock/gmock.h>

#include "run/stored_verdicts.hpp"
#include "stages/program.hpp"
#include "support/folder.hpp"

namespace piae::stages {
namespace {

using testing::HasSubstr;

const Arguments judged_cells{"--run",    "run",    "--dataset", "toys", "--methods",     "none",
                             "--ratios", "100to1", "--seeds",   "0",    "--classifiers", "nearest"};

TEST(Verdicts, AreTabulatedBesideThoseOfOthers) {
  const Folder folder;
  const run::Layout layout(folder / "run", "toys");
  run::store_verdicts(layout, 0, {0, 1, 2, 2});
  folder.write("others.csv", "record,grade,Ann\na-1,Y2,right\na-2,N1,wrong\nb-1,Y1,right\n");
  const auto tabulated = [&](const Arguments& further) {
    Arguments arguments = judged_cells;
    arguments.insert(arguments.end(), further.begin(), further.end());
    const Outcome outcome = run(folder.path(), "verdicts", arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_EQ(tabulated({"--others", "others.csv"}),
            "tabulated 2 judges on 4 records: run/toys/verdicts.md\n");
  EXPECT_THAT(bytes_of(layout.verdicts_csv()), HasSubstr("\ntoys,Ann,Ann,,,,a-2,"));
  EXPECT_THAT(bytes_of(layout.verdicts_csv()),
              HasSubstr("\ntoys,nearest,none,nearest,100to1,0,a-2,"));
  EXPECT_THAT(bytes_of(layout.verdicts_markdown()),
              HasSubstr("| Ann     |          2 |      0 |              2 |\n"
                        "| nearest |          2 |      0 |              2 |"));

  EXPECT_EQ(tabulated({}), "tabulated 1 judges on 4 records: run/toys/verdicts.md\n");
  EXPECT_THAT(bytes_of(layout.verdicts_csv()), testing::Not(HasSubstr("Ann")));
}

TEST(Verdicts, ThatAreMissingAreNamedAndNothingIsWritten) {
  const Folder folder;
  expect_refusal(run(folder.path(), "verdicts", judged_cells), "verdicts", 66,
                 {"classification.h5"});
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace piae::stages
