#include "figures/quality.hpp"

#include "figures/stored_source.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

using Quality = StoredSource;

TEST_F(Quality, HasEachScoreAndItsMeanOverTheSeeds) {
  add_all();  // MMD of the class with label 1: 0.5 and 0.7
  Source all = source("none vae", "100to1 10to1 2to1");
  const std::string first = three_classes("cwru").classes[1].name;
  const Numbers quality = quality_of_methods(all);
  EXPECT_EQ(field(quality, "mmd," + first + ",vae,0", 4), "0.5");
  EXPECT_EQ(field(quality, "mmd," + first + ",vae,1", 4), "0.7");
  EXPECT_EQ(field(quality, "mmd," + first + ",vae,mean", 4), "0.6");
  EXPECT_EQ(field(quality, "rmse," + first + ",vae,mean", 4), "1.2");
  EXPECT_EQ(field(quality, "amplitude_ratio," + first + ",vae,0", 4), "4");
}

TEST_F(Quality, IsLeftOutOfARunWithoutGeneratedWindows) {
  add(diagnosis("none", "100to1", 0, 0, 12));
  Source baseline = source("none", "100to1", "0");
  EXPECT_THROW(quality_of_methods(baseline), LeftOut);
}

TEST_F(Quality, NamesAMissingScore) {
  add_all();
  std::filesystem::remove(layout_.score("vae", 1));
  Source all = source("none vae", "100to1 10to1 2to1");
  EXPECT_ERROR(quality_of_methods(all), Exit::input_missing, "method vae, seed 1");
}

}  // namespace
}  // namespace piae::figures
