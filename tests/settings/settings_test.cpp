#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <toml++/toml.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "cli/toml_options.hpp"
#include "settings/facts.hpp"
#include "settings/protocol.hpp"
#include "settings/settings_folder.hpp"
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

const std::string header = "# Made from PIPELINE; edit that file, not this one.\n";

/// pipeline/ of a project, and the settings of a run.
struct Project {
  Folder folder;
  std::filesystem::path run = folder / "run";

  explicit Project(const std::string& protocol) { folder.write("protocol.toml", protocol); }

  [[nodiscard]] bool is_outdated(const std::string& request) const {
    return SettingsFolder(folder.path(), run).is_outdated(request);
  }
  void update(const std::string& request) const {
    SettingsFolder(folder.path(), run).update(request);
  }
  /// What stands in a settings file, without the line that says where it is from.
  [[nodiscard]] std::string values_in(const std::string& file) const {
    const std::string text = bytes_of(run / file);
    return text.substr(text.find('\n') + 1);
  }
  /// The reason for which its protocol is refused.
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

TEST(SettingsFolder, AFileHoldsWhatTheStageReads) {
  const Project project(
      "[train]\nepochs = 200 # of them\n[train.vae]\nrate = 0.5\nepochs = 3\n"
      "[train.ae]\nlike = \"vae\"\nname = \"x\"\n");
  project.update("train.vae.toml");
  EXPECT_EQ(project.values_in("train.vae.toml"), "epochs = 3\nrate = 0.5\n");
  project.update("train.ae.toml");
  EXPECT_EQ(project.values_in("train.ae.toml"), "epochs = 3\nname = 'x'\nrate = 0.5\n");
  project.update("train.smote.toml");
  EXPECT_EQ(project.values_in("train.smote.toml"), "epochs = 200\n");
  project.update("score.toml");
  EXPECT_EQ(project.values_in("score.toml"), "\n");
}

/// A project with a data set of two recordings below data/.
struct Recorded : Project {
  const std::string request = "recordings/rig.toml " + (folder / "data").string();

  Recorded() : Project("") {
    folder.write("datasets/rig.toml",
                 "[[record]]\nfile = \"rig/a.csv\"\n[[record]]\nfile = \"rig/b.csv\"\n"
                 "[[record]]\nfile = \"rig/b.csv\"\n");
    folder.write("data/rig/a.csv", "1\n");
    folder.write("data/rig/b.csv", "abc");
  }
};

TEST(SettingsFolder, RecordingsAreComparedByContentInAnyFolder) {
  const Recorded project;
  EXPECT_TRUE(project.is_outdated(project.request));
  project.update(project.request);
  // sha256 of "1\n" and "abc" (FIPS 180-4).
  EXPECT_EQ(project.values_in("recordings/rig.toml"),
            "'rig/a.csv' = '4355a46b19d348dc2f57c046f8ef63d4538ebb936000f3c9ee954a27460dd865'\n"
            "'rig/b.csv' = 'ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad'\n");
  EXPECT_FALSE(project.is_outdated(project.request));
  const auto written = fs::last_write_time(project.run / "recordings/rig.toml");
  const std::string stamps = bytes_of(project.run / "recordings/rig.stamps");
  // Written again, and from another folder, they are the same.
  project.folder.write("data/rig/a.csv", "1\n");
  fs::copy(project.folder / "data", project.folder / "other", fs::copy_options::recursive);
  EXPECT_FALSE(project.is_outdated(project.request));
  EXPECT_FALSE(project.is_outdated("recordings/rig.toml " + (project.folder / "other").string()));
  EXPECT_EQ(bytes_of(project.run / "recordings/rig.stamps"), stamps);
  EXPECT_FALSE(
      SettingsFolder(project.folder.path(), project.run).is_outdated(project.request, true));
  EXPECT_NE(bytes_of(project.run / "recordings/rig.stamps"), stamps);
  project.update(project.request);
  EXPECT_EQ(fs::last_write_time(project.run / "recordings/rig.toml"), written);
  // As long as before, and as old.
  const auto time = fs::last_write_time(project.folder / "data/rig/b.csv");
  project.folder.write("data/rig/b.csv", "abd");
  fs::last_write_time(project.folder / "data/rig/b.csv", time);
  EXPECT_TRUE(project.is_outdated(project.request));
  project.update(project.request);
  EXPECT_FALSE(project.is_outdated(project.request));
}

TEST(SettingsFolder, RecordingsThatAreNotThereHaveNotChanged) {
  const Recorded project;
  project.update(project.request);
  fs::remove_all(project.folder / "data");
  EXPECT_FALSE(project.is_outdated(project.request));
  project.update(project.request);
  project.folder.write("data/rig/b.csv", "abc");
  EXPECT_FALSE(project.is_outdated(project.request));
  project.folder.write("data/rig/b.csv", "abd");
  EXPECT_TRUE(project.is_outdated(project.request));
}

TEST(SettingsFolder, RecordsThatNothingIsSaidOfStayAsTheyAre) {
  const Recorded project;
  project.folder.write("rig/records.h5", "of a stand-in");
  EXPECT_FALSE(project.is_outdated(project.request));
  EXPECT_FALSE(fs::exists(project.run));
}

TEST(SettingsFolder, AFileOfAVariantMayBeOfADatasetToo) {
  const Project project("[sweep]\npoints = [\"batch=1\"]\n[sweep.smote]\npoints = []\n");
  project.update("sweep@smote.cwru.toml 3 cells");
  EXPECT_EQ(project.values_in("sweep@smote.cwru.toml"),
            "# Options given by make: 3 cells\npoints = []\n");
  EXPECT_FALSE(project.is_outdated("sweep@smote.cwru.toml 3 cells"));
  project.update("sweep.cwru.toml");
  EXPECT_EQ(project.values_in("sweep.cwru.toml"), "points = [ 'batch=1' ]\n");
}

TEST(SettingsFolder, ADescriptionHasTheLastWordOnItsSplit) {
  const Project project("[split]\nwindow = 1024\nguard-windows = 2\n");
  project.folder.write("datasets/a.toml", "name = \"a\"\n[split]\nwindow = 4096\n");
  project.folder.write("datasets/b.toml", "name = \"b\"\nlike = \"a\"\n[split]\nmax-stride = 9\n");
  project.update("split.b.toml --protocol blocked");
  EXPECT_EQ(project.values_in("split.b.toml"),
            "# Options given by make: --protocol blocked\nguard-windows = 2\nmax-stride = 9\n"
            "window = 4096\n");
  EXPECT_FALSE(project.is_outdated("split.b.toml --protocol blocked"));
  project.folder.write("datasets/a.toml", "name = \"a\"\n[split]\nwindow = 2048\n");
  EXPECT_TRUE(project.is_outdated("split.b.toml --protocol blocked"));
}

TEST(SettingsFolder, ADescriptionIsStoredWithWhatItTakesFromAnother) {
  const Project project("");
  project.folder.write("datasets/a.toml", "name = \"a\"\nrate = 3\n");
  project.folder.write("datasets/b.toml", "name = \"b\"\nlike = \"a\"\n");
  project.update("datasets/b.toml");
  EXPECT_EQ(project.values_in("datasets/b.toml"), "name = 'b'\nrate = 3\n");
  project.folder.write("datasets/a.toml", "name = \"a\"\nrate = 4\n");
  EXPECT_TRUE(project.is_outdated("datasets/b.toml"));
}

TEST(SettingsFolder, WritesThroughNoLink) {
  const Project project("[score]\nepochs = 3\n");
  const std::filesystem::path elsewhere = project.folder / "elsewhere";
  std::filesystem::create_directories(elsewhere);
  std::filesystem::create_directory_symlink(elsewhere, project.run);
  EXPECT_ERROR(project.update("score.toml"), Exit::failed, "run: is a link");
  EXPECT_TRUE(std::filesystem::is_empty(elsewhere));
}

TEST(SettingsFolder, AStageReadsFromTheFileWhatItReadsFromTheProtocol) {
  const auto pipeline = std::filesystem::path(PIAE_SOURCE) / "pipeline";
  const Folder run;
  const SettingsFolder folder(pipeline, run.path());
  const toml::table protocol = read_protocol(pipeline / "protocol.toml");
  for (const std::string& method : augment::method_names()) {
    const std::string name = "train." + method + ".toml";
    folder.update(name);
    const toml::table stored = toml::parse(bytes_of(run / name));
    EXPECT_EQ(cli::options_of(stored, "train", method), cli::options_of(protocol, "train", method))
        << method;
  }
}

TEST(SettingsFolder, NumbersSurviveTheWayThroughAFile) {
  Stream random("settings");
  for (int i = 0; i < 20000; ++i) {
    const double number =
        std::ldexp(random.normal(0, 1), static_cast<int>(random.below(200)) - 100);
    std::ostringstream text;
    text << toml::toml_formatter(toml::table{{"x", number}});
    const toml::table back = toml::parse(text.str());
    ASSERT_EQ(back["x"].value<double>(), number) << text.str();
  }
  for (const double number : {1e8, 0.1, 5e-324, 1.7976931348623157e308, -0.0, 100.0}) {
    std::ostringstream text;
    text << toml::toml_formatter(toml::table{{"x", number}});
    const auto back = toml::parse(text.str())["x"].value<double>();
    ASSERT_EQ(back, number);
    ASSERT_EQ(std::signbit(*back), std::signbit(number));
  }
}

TEST(SettingsFolder, CommentsSpacingAndOrderMakeNothingOutdated) {
  const Project project("[split]\nwindow = 1024 # samples\nstride = 5\n");
  EXPECT_TRUE(project.is_outdated("split.toml"));
  project.update("split.toml");
  EXPECT_FALSE(project.is_outdated("split.toml"));
  project.folder.write("protocol.toml", "# top\n[score]\n[split]\n  stride=5\n\nwindow = 1_024\n");
  EXPECT_FALSE(project.is_outdated("split.toml"));
  project.folder.write("protocol.toml", "[split]\nstride = 5\nwindow = 1025\n");
  EXPECT_TRUE(project.is_outdated("split.toml"));
  project.folder.write("protocol.toml", "[split]\nwindow = 1024\n");
  EXPECT_TRUE(project.is_outdated("split.toml"));
}

TEST(SettingsFolder, OptionsOnTheCommandLineCountAsSettings) {
  const Project project("[split]\nwindow = 1024\n");
  project.update("split.toml --protocol random");
  EXPECT_EQ(project.values_in("split.toml"),
            "# Options given by make: --protocol random\nwindow = 1024\n");
  EXPECT_FALSE(project.is_outdated("split.toml --protocol random"));
  EXPECT_TRUE(project.is_outdated("split.toml --protocol blocked"));
  EXPECT_TRUE(project.is_outdated("split.toml"));
}

TEST(SettingsFolder, AFileOfOlderProgramsWithTheSameValuesIsKept) {
  const Project project(
      "[train]\nepochs = 200\n[train.vae]\nrate = 5e-4\n[train.ae]\nlike = \"vae\"\n");
  const std::string older =
      header + "[train]\nepochs = 200\n[train.vae]\nrate = 5e-4\n[train.ae]\nlike = \"vae\"\n";
  project.folder.write("run/train.ae.toml", older);
  EXPECT_FALSE(project.is_outdated("train.ae.toml"));
  project.update("train.ae.toml");
  EXPECT_EQ(bytes_of(project.run / "train.ae.toml"), older);
}

TEST(SettingsFolder, ADescriptionIsTakenWhole) {
  const Project project("");
  project.folder.write("datasets/rig.toml",
                       "name = \"rig\" # mine\n[[class]]\nname = \"a\"\n[[class]]\nname = \"b\"\n");
  EXPECT_TRUE(project.is_outdated("datasets/rig.toml"));
  project.update("datasets/rig.toml");
  EXPECT_FALSE(project.is_outdated("datasets/rig.toml"));
  project.folder.write("datasets/rig.toml",
                       "name = \"rig\"\n[[class]]\nname = \"b\"\n[[class]]\nname = \"a\"\n");
  EXPECT_TRUE(project.is_outdated("datasets/rig.toml")) << "labels are in the order of the file";
}

TEST(SettingsFolder, ADamagedFileIsOutdated) {
  const Project project("[split]\nwindow = 1024\n");
  project.folder.write("run/split.toml", "window = \n");
  EXPECT_TRUE(project.is_outdated("split.toml"));
  project.update("split.toml");
  EXPECT_FALSE(project.is_outdated("split.toml"));
}

TEST(SettingsFolder, ReadingWritesNothingAndUpdatingWritesOnlyWhatChanged) {
  const Project project("[split]\nwindow = 1024\n");
  EXPECT_TRUE(project.is_outdated("split.toml"));
  EXPECT_FALSE(std::filesystem::exists(project.run));
  project.update("split.toml");
  const auto long_ago = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  std::filesystem::last_write_time(project.run / "split.toml", long_ago);
  project.update("split.toml");
  EXPECT_EQ(std::filesystem::last_write_time(project.run / "split.toml"), long_ago);
}

TEST(SettingsFolder, ProgramsThatUpdateAtOnceDoNotDisturbEachOther) {
  const Project project("[split]\nwindow = 1024\n");
  for (int round = 0; round < 20; ++round) {
    const std::string value = std::to_string(round);
    project.folder.write("protocol.toml", "[split]\nwindow = " + value + "\n");
    std::vector<pid_t> writers;
    for (int i = 0; i < 4; ++i) {
      writers.push_back(::fork());
      if (writers.back() > 0) continue;
      try {
        project.update("split.toml");
      } catch (const std::exception&) {
        ::_exit(1);
      }
      ::_exit(0);
    }
    for (const pid_t writer : writers) {
      int status = 0;
      ::waitpid(writer, &status, 0);
      EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(project.values_in("split.toml"), "window = " + value + "\n");
    const std::filesystem::directory_iterator files(project.run);
    EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "a partial file is left";
  }
}

TEST(SettingsFolder, RefusesWhatIsNoSettingsFileAndWhatCannotBeWritten) {
  const Project project("[split]\nwindow = 1024\n");
  project.folder.write("file", "");
  for (const std::string request : {"split", "", "elsewhere/split.toml", "../split.toml"}) {
    EXPECT_THROW((void)project.is_outdated(request), Error) << request;
  }
  const SettingsFolder blocked(project.folder.path(), project.folder / "file");
  EXPECT_THROW(blocked.update("split.toml"), Error);
  EXPECT_THROW((void)project.is_outdated("datasets/none.toml"), Error);
}

TEST(Protocol, TheProjectsOwnIsAccepted) {
  EXPECT_NO_THROW(
      (void)read_protocol(std::filesystem::path(PIAE_SOURCE) / "pipeline/protocol.toml"));
}

/// The paper's eq. 13 stands for one bearing, whether a method or `simulate` computes with it.
TEST(Protocol, TakesTheParametersOfTheSimulatedBearing) {
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

TEST(Protocol, WhatNothingReadsIsRefusedWithItsLine) {
  EXPECT_THAT(
      Project("[split]\n[diagnoze]\n").refusal(),
      HasSubstr("protocol.toml, line 2: nothing reads the table [diagnoze]; there are split"));
  EXPECT_THAT(Project("[train]\n[train.smot]\n").refusal(),
              HasSubstr("line 2: nothing reads the table [train.smot]; there are train.dynamics"));
  EXPECT_THAT(Project("[train.smote.deep]\n").refusal(), HasSubstr("[train.smote.deep]"));
  EXPECT_THAT(Project("[split.cwru]\n").refusal(), HasSubstr("[split.cwru]"));
  EXPECT_THAT(Project("[[split]]\n").refusal(), HasSubstr("[split]"));
  EXPECT_THAT(Project("[train]\n[train.ae]\nlike = \"ae\"\n").refusal(),
              HasSubstr("protocol.toml, line 2: table of 'ae': like = 'ae' must name a variant"));
  EXPECT_THAT(Project("[train.ae]\nlike = \"vae\"\n").refusal(),
              HasSubstr("protocol.toml, line 1: table of 'ae': like = 'vae' must name"));
  EXPECT_THAT(Project("window = 3\n").refusal(), HasSubstr("line 1: window stands in no table"));
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

/// A group of data sets as it should be, on the first three lines.
const std::string group_a =
    "[transfer.a]\ndatasets = [\"x\"]\nagainst = \"smote\"\ninputs = [\"none=wdcnn\"]\n";

TEST(Protocol, AGroupThatIsNoneIsRefusedWithItsLine) {
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
              HasSubstr("line 3: transfer.a.against names no method: 'smoke'"));
  EXPECT_THAT(refusal("against = \"smote\"", ""),
              HasSubstr("line 1: transfer.a.against names no method: ''"));
  EXPECT_THAT(refusal("none=wdcnn", "none"),
              HasSubstr("line 4: transfer.a.inputs: 'none' is not METHOD=CLASSIFIER"));
  EXPECT_THAT(
      refusal("none=wdcnn", "nine=wdcnn"),
      HasSubstr("line 4: transfer.a.inputs: 'nine=wdcnn' names a method that there is not"));
  EXPECT_THAT(refusal("none=wdcnn", "none=cnn"),
              HasSubstr("'none=cnn' names no classifier that is trained; such are wdcnn, wdcnn-"));
  EXPECT_THAT(refusal("none=wdcnn", "none=nearest"), HasSubstr("no classifier that is trained"));
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
              HasSubstr("line 2: transfer.against stands in no group of data sets"));
  EXPECT_THAT(Project(group_a + "[transfer.a.inner]\n").refusal(),
              HasSubstr("line 5: nothing reads the table [transfer.a.inner]"));
}

/// Who takes a description away can still run all else.
TEST(Protocol, AGroupOfAnUnknownDatasetIsRefusedWhereItIsAskedFor) {
  const Project project(group_a + "[split]\nwindow = 3\n");
  project.update("split.toml");
  EXPECT_THAT(facts(project.folder.path()), Contains("group-dataset:a/x"));
  EXPECT_ERROR(project.is_outdated("transfer.a.toml"), Exit::bad_input,
               "protocol.toml, line 2: transfer.a.datasets holds 'x', and there is no ");
  project.folder.write("datasets/x.toml", "name = \"x\"\n");
  project.update("transfer.a.toml");
  EXPECT_EQ(project.values_in("transfer.a.toml"),
            "against = 'smote'\ndatasets = [ 'x' ]\ninputs = [ 'none=wdcnn' ]\n");
}

TEST(Protocol, PointsOfASweepMustBeWhatItsMethodTakes) {
  EXPECT_THAT(Project("[sweep]\npoints = [\"batch=1\",\n\"batches=mixd\"]\n").refusal(),
              AllOf(HasSubstr("protocol.toml, line 3: sweep.points holds 'batches=mixd'"),
                    HasSubstr("of piae-dt --batches: 'mixd' is none of: ")));
  EXPECT_THAT(Project("[sweep.smote]\npoints = [\"neighbours=2\",\n\"depth=1\"]\n").refusal(),
              HasSubstr("line 3: sweep.smote.points holds 'depth=1', but of smote there is no "
                        "option --depth"));
  EXPECT_THAT(Project("[sweep.smote]\npoints = [\"neighbours=2\",\n\"neighbours\"]\n").refusal(),
              HasSubstr("line 3: sweep.smote.points holds 'neighbours', which is not FACTOR="));
  EXPECT_THAT(Project("[sweep.smote]\npoints = [\"neighbours=2\"]\n").refusal(), "not refused");
}

TEST(Protocol, TheTableOfASweepIsOfAMethodAndAClassifier) {
  EXPECT_THAT(Project("[sweep]\n[sweep.smot]\n").refusal(),
              HasSubstr("line 2: nothing reads the table [sweep.smot]; there are sweep.dynamics"));
  for (const std::string other : {"piae-dt", "oracle", "none"}) {
    EXPECT_THAT(Project("[sweep." + other + "]\npoints = []\n").refusal(),
                HasSubstr("line 1: nothing reads the table [sweep." + other + "]"));
  }
  EXPECT_THAT(
      Project("[sweep.smote]\npoints = []\nclassifier = \"wdcn\"\n").refusal(),
      HasSubstr("protocol.toml, line 3: unknown classifier 'wdcn'; known are wdcnn, wdcnn-"));
  EXPECT_THAT(Project("[sweep.smote]\npoints = []\nclassifier = 3\n").refusal(),
              HasSubstr("line 3: unknown classifier ''"));
  EXPECT_THAT(Project("[sweep.smote]\nclassifier = \"wdcnn\"\n").refusal(),
              HasSubstr("line 1: sweep.smote has no points"));
  EXPECT_THAT(Project("[sweep.smote]\npoints = []\npoint = []\n").refusal(),
              HasSubstr("line 3: nothing reads sweep.smote.point"));
  EXPECT_THAT(Project("[sweep]\nclassifier = \"wdcnn\"\n").refusal(),
              HasSubstr("line 2: nothing reads sweep.classifier"));
}

TEST(Protocol, TheCentreOfASweepIsWhatTheMethodHasAnyway) {
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

TEST(Protocol, HasASweepOfEachMethodWithATable) {
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

TEST(Facts, NameWhatThereIs) {
  const std::vector<std::string> all = facts(std::filesystem::path(PIAE_SOURCE) / "pipeline");
  for (const std::string fact : {"method:none",
                                 "method:smote",
                                 "method:oracle",
                                 "paper:ae",
                                 "paper:none",
                                 "default:none",
                                 "default:piae-dt-rnn",
                                 "default:piae-dt-phase",
                                 "default:shift",
                                 "baseline:none",
                                 "ceiling:oracle",
                                 "infers:piae-dt-phase",
                                 "infers:piae-dt-tcn",
                                 "method:piae-dt-transformer",
                                 "ratio:1to1",
                                 "classifier:wdcnn-spectrum",
                                 "paper-classifier:wdcnn",
                                 "bar:nearest",
                                 "nothing-generated:100to1",
                                 "dataset:cwru",
                                 "simulated:simulated",
                                 "swept:piae-dt",
                                 "paper-method:piae-dt",
                                 "sweep-classifier:piae-dt:wdcnn",
                                 "sweep-point:piae-dt:depth=1",
                                 "sweep-centre:piae-dt:depth=3",
                                 "swept:strike-twin",
                                 "sweep-classifier:strike-twin:wdcnn-spectra",
                                 "sweep-point:strike-twin:edges=known",
                                 "reading:batches=class",
                                 "reading-base:batches=mixed",
                                 "group:speeds",
                                 "group-dataset:speeds/hit-sm-1200to900",
                                 "group-method:sizes/strike-twin",
                                 "group-input:sizes/strike-twin=wdcnn-spectra"}) {
    EXPECT_THAT(all, Contains(fact));
  }
  for (const std::string fact :
       {"paper:piae-dt-phase", "default:oracle", "default:oversample", "paper:oracle",
        "paper:piae-dt-tcn", "default:piae-dt-tcn", "default:piae-dt-transformer", "infers:smote",
        "simulated:cwru", "sweep-centre:piae-dt:depth=1"}) {
    EXPECT_THAT(all, Not(Contains(fact)));
  }
}

TEST(Facts, ABrokenDescriptionIsNobodysTroubleUntilItIsAskedFor) {
  const Project project("");
  project.folder.write("datasets/broken.toml", "name = \n");
  project.folder.write("datasets/made.toml", "[simulation]\n");
  EXPECT_THAT(facts(project.folder.path()), Contains("dataset:broken"));
  EXPECT_THAT(facts(project.folder.path()), Contains("simulated:made"));
  project.folder.write("datasets/like.toml",
                       "name = \"like\"\nlike = \"made\"\n[split]\nwindow = 3\n");
  EXPECT_THAT(facts(project.folder.path()), Contains("simulated:like"));
  EXPECT_THAT(facts(project.folder.path()), Contains("own-split:like"));
  EXPECT_THAT(facts(project.folder.path()), Not(Contains("own-split:made")));
  EXPECT_THROW((void)project.is_outdated("datasets/broken.toml"), Error);
}

TEST(Facts, NameTheDataSetsOfWhichNothingIsKnown) {
  const Project project("");
  const auto of_nothing = [&] {
    std::vector<std::string> names;
    for (const std::string& fact : facts(project.folder.path())) {
      if (fact.starts_with("nothing-known:")) names.push_back(fact.substr(14));
    }
    return names;
  };
  project.folder.write("datasets/five.toml", "name = \"five\"\n[split]\nknown-per-class = 5\n");
  project.folder.write("datasets/said.toml", "name = \"said\"\n");
  project.folder.write("datasets/zero.toml", "name = \"zero\"\n[split]\nknown-per-class = 0\n");
  project.folder.write("datasets/zero-wide.toml",
                       "name = \"zero-wide\"\nlike = \"zero\"\n[split]\nwindow = 3\n");
  EXPECT_THAT(of_nothing(), ElementsAre("zero-wide", "zero"));
  project.folder.write("protocol.toml", "[split]\nknown-per-class = 0\n");
  EXPECT_THAT(of_nothing(), ElementsAre("said", "zero-wide", "zero"));
}

TEST(Facts, NameWhichMethodsHaveCellsByWhichClassifiers) {
  const std::vector<std::string> all = facts(std::filesystem::path(PIAE_SOURCE) / "pipeline");
  for (const std::string pair : {"none/wdcnn", "none/nearest", "smote/nearest", "oracle/wdcnn"}) {
    EXPECT_THAT(all, Contains("pair:" + pair));
  }
  EXPECT_THAT(all, Contains("pair-of-nothing:oracle/wdcnn"));
  EXPECT_THAT(all, Contains("pair-of-nothing:oracle/nearest"));
  for (const std::string pair : {"none/wdcnn", "none/nearest", "smote/nearest"}) {
    EXPECT_THAT(all, Not(Contains("pair-of-nothing:" + pair)));
  }
}

}  // namespace
}  // namespace piae::settings
