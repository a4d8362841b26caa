#include "diagnosis/any_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/learn.hpp"
#include "diagnosis/taught.hpp"
#include "support/errors.hpp"
#include "support/impact_windows.hpp"

namespace piae::diagnosis {
namespace {

class AnyBearingOnAToy : public testing::Test {
 protected:
  AnyBearingOnAToy() {
    Stream stream("any");
    add_impact_windows(normal_, 0, 20, stream);
    for (const Label label : {0, 1, 2}) add_impact_windows(test_, label, 10, stream);
  }

  const Folder folder_;
  signal::WindowSet normal_ = no_impact_windows();
  signal::WindowSet test_ = no_impact_windows();
};

// The network has never seen a window of this machine, nor any window at all.
TEST_F(AnyBearingOnAToy, NamesTheFaultType) {
  const auto fitted = fit_any_bearing(taught_network(folder_), normal_);
  const Outputs outputs = fitted->outputs(test_, "--test");
  EXPECT_EQ(most_likely(outputs.scores, 3), test_.labels);
  EXPECT_EQ(outputs.hidden.size(), 30U * 48);
}

// Logits of classes that the data set lacks, here the ball's, do not count.
TEST_F(AnyBearingOnAToy, SharesItsProbabilityAmongTheClassesOfTheDataSet) {
  const auto fitted = fit_any_bearing(taught_network(folder_), normal_);
  const Outputs outputs = fitted->outputs(test_, "--test");
  for (std::size_t i = 0; i < test_.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += std::exp(outputs.logits[3 * i + k]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(outputs.scores[3 * i + k], std::exp(outputs.logits[3 * i + k]) / sum, 1e-5);
    }
  }
}

TEST_F(AnyBearingOnAToy, MeasuresAsItWasTaught) {
  const auto plain = fit_any_bearing(taught_network(folder_), normal_);
  const auto prewhitened = fit_any_bearing(taught_network(folder_, 1), normal_);
  EXPECT_NE(plain->outputs(test_, "--test").logits, prewhitened->outputs(test_, "--test").logits);
}

TEST_F(AnyBearingOnAToy, IsKeptWithItsPrewhitening) {
  const auto fitted = fit_any_bearing(taught_network(folder_, 1), normal_);
  artefact::Writer writer("classifier");
  fitted->write(writer);
  const artefact::Reader reader = stored(writer, folder_);
  const auto read = read_any_bearing(reader, test_.info, test_.length);
  EXPECT_EQ(read->outputs(test_, "--test").logits, fitted->outputs(test_, "--test").logits);
}

TEST_F(AnyBearingOnAToy, NeedsANetwork) {
  EXPECT_ERROR(
      learn(any_bearing, normal_, normal_, {}, Stream("toy")), Exit::usage,
      "--classifier any-bearing needs --network, such as results/reference/any-bearing.h5");
}

TEST_F(AnyBearingOnAToy, RefusesWhatRulesRefuse) {
  const artefact::Reader network = taught_network(folder_);
  signal::WindowSet twice = normal_;
  twice.info.classes.push_back({.name = "OR021", .defect = signal::Defect::outer});
  EXPECT_ERROR(fit_any_bearing(network, twice), Exit::bad_input,
               "has several classes of one type, ");
  signal::WindowSet other = normal_;
  other.info.classes[1].defect = signal::Defect::other;
  EXPECT_ERROR(fit_any_bearing(network, other), Exit::bad_input, "does not have a fault line");
  signal::WindowSet few = no_impact_windows();
  Stream stream("few");
  add_impact_windows(few, 0, 7, stream);
  EXPECT_ERROR(fit_any_bearing(network, few), Exit::bad_input, "too few for a baseline");
}

TEST_F(AnyBearingOnAToy, RefusesADamagedNetwork) {
  artefact::Writer writer("any-bearing");
  writer.attribute("/", "seed", std::int64_t{0});
  const artefact::Reader empty = stored(writer, folder_);
  EXPECT_THROW((void)fit_any_bearing(empty, normal_), artefact::Refusal);
}

}  // namespace
}  // namespace piae::diagnosis
