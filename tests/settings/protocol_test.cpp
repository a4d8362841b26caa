#include "settings/protocol.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>

#include "base/error.hpp"
#include "settings/groups.hpp"
#include "settings/sweeps.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::settings {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

/// The folder pipeline/ of a project.
struct Project {
  Folder folder;

  explicit Project(const std::string& protocol) { folder.write("protocol.toml", protocol); }

  /// Returns why its protocol is refused.
  [[nodiscard]] std::string refusal() const {
    try {
      (void)read_protocol(folder / "protocol.toml");
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::bad_input);
      return error.what();
    }
    return "not refused";
  }
};

TEST(Protocol, AcceptsTheFileOfTheProject) {
  EXPECT_NO_THROW(
      (void)read_protocol(std::filesystem::path(PIAE_SOURCE) / "pipeline/protocol.toml"));
}

/// The paper's eq. 13 describes one bearing, so methods and `simulate` must use the same values.
TEST(Protocol, HasTheParametersOfTheSimulatedBearing) {
  const fs::path pipeline = fs::path(PIAE_SOURCE) / "pipeline";
  const toml::table protocol = toml::parse_file((pipeline / "protocol.toml").string());
  const toml::table simulated = toml::parse_file((pipeline / "datasets/simulated.toml").string());
  std::size_t compared = 0;
  for (const auto& [key, value] : *protocol["train"]["dynamics"].as_table()) {
    std::string there(key.str());
    std::ranges::replace(there, '-', '_');
    const auto expected = simulated["simulation"][there].value<double>();
    ASSERT_TRUE(expected.has_value()) << there;
    EXPECT_EQ(value.value<double>(), expected) << there;
    ++compared;
  }
  EXPECT_EQ(compared, 9U);
  EXPECT_EQ(protocol["train"]["strike-twin"]["mass-kg"].value<double>(),
            protocol["train"]["dynamics"]["mass-kg"].value<double>());
}

TEST(Protocol, RefusesUnreadKeysWithTheirLine) {
  EXPECT_THAT(
      Project("[split]\n[diagnoze]\n").refusal(),
      HasSubstr(
          "protocol.toml, line 2: nothing reads the table [diagnoze]; known tables are split"));
  EXPECT_THAT(
      Project("[train]\n[train.smot]\n").refusal(),
      HasSubstr("line 2: nothing reads the table [train.smot]; known tables are train.dynamics"));
  EXPECT_THAT(Project("[train.smote.deep]\n").refusal(), HasSubstr("[train.smote.deep]"));
  EXPECT_THAT(Project("[split.cwru]\n").refusal(), HasSubstr("[split.cwru]"));
  EXPECT_THAT(Project("[[split]]\n").refusal(), HasSubstr("[split]"));
  EXPECT_THAT(Project("[train]\n[train.ae]\nlike = \"ae\"\n").refusal(),
              HasSubstr("protocol.toml, line 2: table of 'ae': like = 'ae' must name a variant"));
  EXPECT_THAT(Project("[train.ae]\nlike = \"vae\"\n").refusal(),
              HasSubstr("protocol.toml, line 1: table of 'ae': like = 'vae' must name"));
  EXPECT_THAT(Project("window = 3\n").refusal(), HasSubstr("line 1: window is not in a table"));
  EXPECT_THAT(Project("[split\n").refusal(), HasSubstr("line 1: not valid TOML"));
  EXPECT_THAT(Project("[sweep]\npoints = [\"batch=1\",\n\"batch\"]\n").refusal(),
              HasSubstr("line 3: sweep.points holds 'batch', which is not FACTOR=VALUE"));
  EXPECT_THAT(Project("[readings]\nreadings = [\"a=b\",\n\"a=b+c\"]\n").refusal(),
              HasSubstr("line 3: readings.readings holds 'a=b+c', which is not FACTOR=VALUE"));
  EXPECT_THAT(Project("[readings]\nbase = \"a=b\"\n").refusal(),
              HasSubstr("line 2: readings.base must be a list"));
  EXPECT_THAT(Project("[readings]\nreadings = [\"a=b\",\n\"c=d\", \"a=b\"]\n").refusal(),
              HasSubstr("line 3: readings.readings holds 'a=b' twice"));
  EXPECT_THAT(Project("[readings]\nreadings = [\"a=b+c=d+a=e\"]\n").refusal(),
              HasSubstr("line 2: readings.readings holds 'a=b+c=d+a=e', which sets a twice"));
}

/// A valid group of data sets, on the first three lines.
const std::string group_a =
    "[transfer.a]\ndatasets = [\"x\"]\nagainst = \"smote\"\ninputs = [\"none=wdcnn\"]\n";

TEST(Protocol, RefusesInvalidGroupsWithTheirLine) {
  EXPECT_EQ(Project(group_a).refusal(), "not refused");
  const auto refusal = [](const std::string& from, const std::string& to) {
    std::string text = group_a;
    return Project(text.replace(text.find(from), from.size(), to)).refusal();
  };
  EXPECT_THAT(refusal("[\"x\"]", "[]"),
              HasSubstr("protocol.toml, line 2: transfer.a.datasets must be a list of words"));
  EXPECT_THAT(refusal("[\"x\"]", "[\"x\",\n\"x\"]"),
              HasSubstr("line 3: transfer.a.datasets holds 'x' twice"));
  EXPECT_THAT(refusal("datasets = [\"x\"]", ""),
              HasSubstr("line 1: [transfer.a] has no list datasets"));
  EXPECT_THAT(refusal("datasets", "data"),
              HasSubstr("line 2: nothing reads transfer.a.data; a group has datasets, against, "));
  EXPECT_THAT(refusal("\"smote\"", "\"smoke\""),
              HasSubstr("line 3: transfer.a.against must name a method, not 'smoke'"));
  EXPECT_THAT(refusal("against = \"smote\"", ""),
              HasSubstr("line 1: transfer.a.against must name a method, not ''"));
  EXPECT_THAT(refusal("none=wdcnn", "none"),
              HasSubstr("line 4: transfer.a.inputs: 'none' is not METHOD=CLASSIFIER"));
  EXPECT_THAT(refusal("none=wdcnn", "nine=wdcnn"),
              HasSubstr("line 4: transfer.a.inputs: 'nine=wdcnn' names an unknown method"));
  EXPECT_THAT(refusal("none=wdcnn", "none=cnn"),
              HasSubstr("'none=cnn' names an unknown classifier"));
  EXPECT_THAT(refusal("none=wdcnn", "shift=envelope-rule"),
              HasSubstr("'shift=envelope-rule' does not go together: rules run with none only"));
  EXPECT_EQ(refusal("none=wdcnn", "none=nearest"), "not refused");
  EXPECT_THAT(refusal("\"none=wdcnn\"", "\"none=wdcnn\",\n\"none=wdcnn-spectra\""),
              HasSubstr("line 5: transfer.a.inputs names an input of none twice"));
  EXPECT_THAT(
      Project(group_a + "kind-inputs = [\"none=wdcnn\",\n\"none=wdcnn-spectra\"]\n").refusal(),
      HasSubstr("line 6: transfer.a.kind-inputs names an input of none twice"));
  EXPECT_THAT(
      Project(group_a + "kind-inputs = [\"vae=wdcnn\"]\n").refusal(),
      HasSubstr("line 5: transfer.a.kind-inputs must name an input of each method of inputs"));
  EXPECT_THAT(Project(group_a + "kind-inputs = [\"none=wdcnn-spectra\"]\n").refusal(),
              "not refused");
  EXPECT_THAT(refusal("[transfer.a]", "[transfer.\"a b\"]"), HasSubstr("line 1: the name of"));
  EXPECT_THAT(Project("[transfer]\nagainst = \"smote\"\n").refusal(),
              HasSubstr("line 2: transfer.against is not in a group of data sets"));
  EXPECT_THAT(Project(group_a + "[transfer.a.inner]\n").refusal(),
              HasSubstr("line 5: nothing reads the table [transfer.a.inner]"));
}

/// Everything else still runs after a description was removed.
TEST(Protocol, RefusesARequestedGroupWithAnUnknownDataset) {
  const Project project(group_a);
  const toml::table protocol = read_protocol(project.folder / "protocol.toml");
  EXPECT_ERROR(require_datasets(protocol, "a", project.folder.path()), Exit::bad_input,
               "protocol.toml, line 2: transfer.a.datasets holds 'x', but there is no ");
  project.folder.write("datasets/x.toml", "name = \"x\"\n");
  EXPECT_NO_THROW(require_datasets(protocol, "a", project.folder.path()));
}

TEST(Protocol, RefusesSettingsThatTheMethodRefuses) {
  EXPECT_THAT(Project("[train.flow]\nsteps = 8\nlatent = 20\n").refusal(),
              HasSubstr("protocol.toml, line 3: train.flow.latent is 20, which flow refuses: there "
                        "is no option --latent"));
  EXPECT_THAT(
      Project("[train.smote]\nneighbours = 0\n").refusal(),
      HasSubstr("line 2: train.smote.neighbours is 0, which smote refuses: --neighbours: "));
  EXPECT_THAT(Project("[train.ae]\nlike = \"piae-dt\"\n[train.piae-dt]\nbackend = \"libtorch\"\n")
                  .refusal(),
              "not refused");
}

TEST(Protocol, RefusesSweepPointsThatTheMethodRefuses) {
  EXPECT_THAT(Project("[sweep]\npoints = [\"batch=1\",\n\"batches=mixd\"]\n").refusal(),
              AllOf(HasSubstr("protocol.toml, line 3: sweep.points holds 'batches=mixd'"),
                    HasSubstr("which piae-dt refuses: --batches: 'mixd' is not one of: ")));
  EXPECT_THAT(Project("[sweep.smote]\npoints = [\"neighbours=2\",\n\"depth=1\"]\n").refusal(),
              HasSubstr("line 3: sweep.smote.points holds 'depth=1', which smote refuses: there is "
                        "no option --depth"));
  EXPECT_THAT(Project("[sweep.smote]\npoints = [\"neighbours=2\",\n\"neighbours\"]\n").refusal(),
              HasSubstr("line 3: sweep.smote.points holds 'neighbours', which is not FACTOR="));
  EXPECT_THAT(Project("[sweep.smote]\npoints = [\"neighbours=2\"]\n").refusal(), "not refused");
}

TEST(Protocol, RefusesSweepTablesWithoutMethodOrClassifier) {
  EXPECT_THAT(
      Project("[sweep]\n[sweep.smot]\n").refusal(),
      HasSubstr("line 2: nothing reads the table [sweep.smot]; known tables are sweep.dynamics"));
  for (const std::string other : {"piae-dt", "oracle", "none"}) {
    EXPECT_THAT(Project("[sweep." + other + "]\npoints = []\n").refusal(),
                HasSubstr("line 1: nothing reads the table [sweep." + other + "]"));
  }
  EXPECT_THAT(Project("[sweep.smote]\npoints = []\nclassifier = \"wdcn\"\n").refusal(),
              HasSubstr("protocol.toml, line 3: unknown classifier 'wdcn'; known: wdcnn, wdcnn-"));
  EXPECT_THAT(Project("[sweep.smote]\npoints = []\nclassifier = 3\n").refusal(),
              HasSubstr("line 3: unknown classifier ''"));
  EXPECT_THAT(Project("[sweep.smote]\nclassifier = \"wdcnn\"\n").refusal(),
              HasSubstr("line 1: sweep.smote has no points"));
  EXPECT_THAT(Project("[sweep.smote]\npoints = []\npoint = []\n").refusal(),
              HasSubstr("line 3: nothing reads sweep.smote.point"));
  EXPECT_THAT(Project("[sweep]\nclassifier = \"wdcnn\"\n").refusal(),
              HasSubstr("line 2: nothing reads sweep.classifier"));
}

TEST(Protocol, HasSweepCentresEqualToTheDefaults) {
  const toml::table protocol = toml::parse(
      "[train]\nbatch = 3\n[train.piae-dt]\nbatch = 5\nrate = 5e-4\nkind = \"plain\"\n"
      "[sweep]\npoints = [\"batch=3\", \"batch=5\", \"rate=0.0005\", \"kind=other\", "
      "\"kind=plain\", \"depth=1\"]\n");
  const std::vector<Sweep> all = sweeps(protocol);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].method, "piae-dt");
  EXPECT_EQ(all[0].classifier, "wdcnn");
  EXPECT_THAT(all[0].centre, ElementsAre("batch=5", "rate=0.0005", "kind=plain"));
}

TEST(Protocol, HasASweepForEachMethodWithATable) {
  const toml::table protocol = toml::parse(
      "[train.vae]\nepochs = 3\n[sweep.vae]\npoints = [\"epochs=2\", \"epochs=3\"]\n"
      "[sweep.smote]\nclassifier = \"nearest\"\npoints = [\"neighbours=2\"]\n");
  const std::vector<Sweep> all = sweeps(protocol);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].method, "smote");
  EXPECT_EQ(all[0].classifier, "nearest");
  EXPECT_THAT(all[0].points, ElementsAre("neighbours=2"));
  EXPECT_EQ(all[1].method, "vae");
  EXPECT_EQ(all[1].classifier, "wdcnn");
  EXPECT_THAT(all[1].centre, ElementsAre("epochs=3"));
}

}  // namespace
}  // namespace piae::settings
