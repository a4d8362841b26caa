#include "figures/identifiability.hpp"

#include "figures/stored_source.hpp"
#include "signal/window_set.hpp"
#include "support/errors.hpp"

namespace piae::figures {
namespace {

class IdentifiabilityFigure : public StoredSource {
 protected:
  void add_known_windows(bool simulated) const {
    signal::WindowSet known;
    known.info = three_classes("cwru");
    known.length = 4;
    known.labels = {1};
    known.samples = {1, 2, 1, 2};
    if (simulated) known.parameters = {{1e8, 500}};
    artefact::Writer writer("windows");
    write(writer, known);
    writer.save(layout_.known_windows(0), {"test", "", {}});
  }
  void add_tables() const {
    folder_.write("run/cwru/scatter.csv",
                  "dataset,method,parameter,truth_low,truth_high,windows,inferred_p10,inferred_p50,"
                  "inferred_p90\n"
                  "cwru,piae-dt,stiffness,8e+07,9e+07,12,2e+07,7e+07,1.1e+08\n"
                  "cwru,piae-dt,damping,400,500,12,20,30,40\n");
    folder_.write("run/cwru/identifiability.csv",
                  "dataset,method,parameter,class,seeds,r2_mean,r2_std\n"
                  "cwru,piae-dt,stiffness,all,2,-1.5000,0.1000\n"
                  "cwru,piae-dt,stiffness,IR,2,0.7000,0.1000\n"
                  "cwru,piae-dt,damping,all,2,0.2500,0.1000\n");
  }
};

TEST_F(IdentifiabilityFigure, ShowsTheGroupsAndR2OfEachParameter) {
  add_known_windows(true);
  add_tables();
  Source one = source("piae-dt", "10to1", "0");
  const Numbers numbers = identifiability(one);
  EXPECT_EQ(field(numbers, "piae-dt,stiffness,8e+07,9e+07,12", 6), "7e+07");
  EXPECT_EQ(field(numbers, "piae-dt,stiffness,8e+07,9e+07,12", 8), "-1.5000");
  EXPECT_EQ(field(numbers, "piae-dt,damping,400,500,12", 5), "20");
  EXPECT_EQ(field(numbers, "piae-dt,damping,400,500,12", 8), "0.2500");
}

TEST_F(IdentifiabilityFigure, CoversOnlySimulatedWindows) {
  add_known_windows(false);
  add_tables();
  Source one = source("piae-dt", "10to1", "0");
  EXPECT_THROW(identifiability(one), LeftOut);
}

TEST_F(IdentifiabilityFigure, NamesMissingWindowsOrTables) {
  Source none = source("piae-dt", "10to1", "0");
  EXPECT_ERROR(identifiability(none), Exit::input_missing, "seed0/C.h5");
  add_known_windows(true);
  Source one = source("piae-dt", "10to1", "0");
  EXPECT_THROW(identifiability(one), LeftOut);
  EXPECT_ERROR(identifiability(one), Exit::input_missing, "run `make identify`: no scatter.csv");
  add_tables();
  std::filesystem::remove(layout_.identifiability_csv());
  EXPECT_ERROR(identifiability(one), Exit::input_missing,
               "run `make identify`: no identifiability.csv");
}

TEST_F(IdentifiabilityFigure, RefusesATableWithoutANeededColumn) {
  add_known_windows(true);
  add_tables();
  folder_.write("run/cwru/scatter.csv", "dataset,method\ncwru,piae-dt\n");
  Source one = source("piae-dt", "10to1", "0");
  EXPECT_ERROR(identifiability(one), Exit::bad_input, "scatter.csv: has no column 'parameter'");
}

}  // namespace
}  // namespace piae::figures
