#include "figures/curves.hpp"

#include "figures/stored_source.hpp"
#include "support/errors.hpp"
#include "twin/curves.hpp"

namespace piae::figures {
namespace {

class CurvesOfAModel : public StoredSource {
 protected:
  /// Adds four epochs; the first and third are of Stage 1, or with `stage_epochs` 2 the first two.
  void add_model(int seed, double loss, const std::string& stage_epochs) const {
    const std::vector<double> falling{4 * loss, 3 * loss, 2 * loss, loss};
    const std::vector<double> ones(4, 1);
    artefact::Writer writer("model");
    write(writer, three_classes("cwru"));
    twin::Curves{falling, ones, ones, ones, {1, 2, 3, 4}, ones, ones, ones}.write(writer);
    writer.save(layout_.model("piae-dt", seed),
                {"train", "stage-epochs = \"" + stage_epochs + "\"\n", {}});
  }
};

TEST_F(CurvesOfAModel, GiveEachEpochItsStage) {
  add_model(0, 1, "1");
  add_model(1, 1, "2");
  Source both = source("piae-dt", "10to1");
  const Numbers losses = loss_curves(both);
  EXPECT_EQ(field(losses, "0,1,1,reconstruction", 4), "4");
  EXPECT_EQ(field(losses, "0,2,2,reconstruction", 4), "3");
  EXPECT_EQ(field(losses, "0,1,3,reconstruction", 4), "2");
  EXPECT_EQ(field(losses, "1,1,2,reconstruction", 4), "3");
  EXPECT_EQ(field(losses, "1,2,3,reconstruction", 4), "2");
}

TEST_F(CurvesOfAModel, EndWithTheMeanOverTheSeeds) {
  add_model(0, 1, "1");
  add_model(1, 2, "1");
  Source both = source("piae-dt", "10to1");
  EXPECT_EQ(field(loss_curves(both), "mean,2,4,reconstruction", 4), "1.5");
  EXPECT_EQ(field(weight_curves(both), "mean,1,3,alpha", 4), "3");
}

/// L_Rec falls from 4 to 1, or from 8 to 2; the means are 6 and 1.5.
TEST_F(CurvesOfAModel, ShowTheStationaryPointOfEachWeight) {
  add_model(0, 1, "1");
  add_model(1, 2, "1");
  Source both = source("piae-dt", "10to1");
  const Numbers weights = weight_curves(both);
  EXPECT_EQ(field(weights, "stationary,1,1,gamma", 4), "0.0833333");
  EXPECT_EQ(field(weights, "stationary,2,4,gamma", 4), "0.333333");
  EXPECT_EQ(field(weights, "stationary,2,4,alpha", 4), "0.5");
}

TEST_F(CurvesOfAModel, NeedThePapersMethodInTheGrid) {
  Source others = source("vae", "10to1");
  EXPECT_ERROR(loss_curves(others), Exit::input_missing, "piae-dt");
}

TEST_F(CurvesOfAModel, NameAMissingModel) {
  add_model(0, 1, "1");
  Source both = source("piae-dt", "10to1");
  EXPECT_ERROR(loss_curves(both), Exit::input_missing, "seed1/piae-dt/model.h5");
}

}  // namespace
}  // namespace piae::figures
