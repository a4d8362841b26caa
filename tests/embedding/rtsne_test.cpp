// Compares the divergence that our t-SNE reaches with that of R's package Rtsne, if it is installed
// (apt-get install r-cran-rtsne).

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "base/numbers.hpp"
#include "embedding/point_sets.hpp"
#include "embedding/tsne.hpp"
#include "support/folder.hpp"

namespace piae::embedding {
namespace {

bool succeeds(const std::string& command) { return std::system(command.c_str()) == 0; }

/// Both programs are exact and take equally many steps. R starts from its own principal components,
/// at our scale, because random starts end in worse minima. R prints the cost of the last step with
/// all digits.
const std::string script = R"(
points <- as.matrix(read.csv("points.csv", header = FALSE))
start <- prcomp(points)$x[, 1:2]
start <- start / sd(start[, 1]) * 1e-4
map <- Rtsne::Rtsne(points, theta = 0, pca = FALSE, perplexity = 30, max_iter = 1000,
                    normalize = FALSE, check_duplicates = FALSE, Y_init = start,
                    stop_lying_iter = 250, mom_switch_iter = 250, num_threads = 1)
cat(sprintf("%.15g", tail(map$itercosts, 1)), file = "cost.txt")
)";

double cost_of_rtsne(const Points& points) {
  const Folder folder;
  const Eigen::IOFormat csv(Eigen::FullPrecision, Eigen::DontAlignCols, ",", "\n");
  std::ostringstream text;
  text << points.format(csv) << '\n';
  folder.write("points.csv", text.str());
  folder.write("rtsne.R", script);
  EXPECT_TRUE(succeeds("cd '" + folder.path().string() + "' && Rscript rtsne.R > log 2>&1"))
      << bytes_of(folder / "log");
  return number_in<double>(bytes_of(folder / "cost.txt")).value_or(0);
}

struct AgainstRtsne : testing::Test {
  void SetUp() override {
    if (!succeeds("Rscript -e 'library(Rtsne)' > /dev/null 2>&1")) {
      GTEST_SKIP() << "R's package Rtsne is not installed (apt-get install r-cran-rtsne)";
    }
  }
};

TEST_F(AgainstRtsne, ReachesTheSameDivergenceForClouds) {
  const Points points = three_clouds(300, 10, 5, "points");
  const double expected = cost_of_rtsne(points);
  EXPECT_NEAR(tsne(points).kl_divergence, expected, 0.05 * expected);
}

TEST_F(AgainstRtsne, ReachesTheSameDivergenceForOneCloud) {
  const Points points = cloud(400, 20, "points");
  const double expected = cost_of_rtsne(points);
  EXPECT_NEAR(tsne(points).kl_divergence, expected, 0.05 * expected);
}

}  // namespace
}  // namespace piae::embedding
