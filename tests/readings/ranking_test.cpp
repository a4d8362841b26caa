#include "readings/ranking.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::readings {
namespace {

const std::string header = "dataset,reading,quantity,ratio,seeds,mean,std\n";

std::string accuracy(const std::string& reading, const std::string& ratio, int percent) {
  return "cwru," + reading + ",accuracy," + ratio + ",2," + std::to_string(percent) + ",1\n";
}

TEST(Ranking, SuggestsChangesOfTheBest) {
  const Folder folder;
  folder.write("readings.csv",
               header + accuracy("base", "10to1", 60) + accuracy("base", "1to1", 50) +
                   accuracy("space=class", "10to1", 65) + accuracy("space=class", "1to1", 51) +
                   accuracy("batches=class", "10to1", 61) + accuracy("batches=class", "1to1", 51) +
                   accuracy("keep=final", "10to1", 99) +  // lacks 1to1
                   accuracy("batches=other", "10to1", 40) + accuracy("batches=other", "1to1", 40) +
                   accuracy("batches=other+space=class", "10to1", 40) +
                   accuracy("batches=other+space=class", "1to1", 40) +
                   "cwru,base,mmd,,2,100,1\ncwru,published,accuracy,10to1,1,99,\n"
                   "cwru,published,accuracy,1to1,1,99,\n");
  EXPECT_EQ(ranking({folder / "readings.csv"}),
            " 58.00  space=class\n 56.00  batches=class\n 55.00  base\n 40.00  batches=other\n"
            " 40.00  batches=other+space=class\nto try next: batches=class+space=class\n"
            "to try next: keep=final+space=class\n");
}

TEST(Ranking, IsTheMeanOverDataSets) {
  const Folder folder;
  folder.write("a.csv", header + accuracy("base", "1to1", 60) + accuracy("x=1", "1to1", 70));
  folder.write("b.csv", header + accuracy("base", "1to1", 90) + accuracy("x=1", "1to1", 60));
  EXPECT_EQ(ranking({folder / "a.csv", folder / "b.csv"}), " 75.00  base\n 65.00  x=1\n");
}

TEST(Ranking, RefusesWhatIsNotANumber) {
  const Folder folder;
  folder.write("a.csv", header + "cwru,base,accuracy,1to1,2,high,1\n");
  EXPECT_ERROR((void)ranking({folder / "a.csv"}), Exit::bad_input,
               "a.csv, line 2: the mean must be a number");
}

}  // namespace
}  // namespace piae::readings
