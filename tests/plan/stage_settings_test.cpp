#include "plan/stage_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "augment/catalogue.hpp"
#include "base/random.hpp"
#include "cli/toml_options.hpp"
#include "plan/settings_files.hpp"
#include "plan/small_run.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::plan {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The project's own pipeline/.
std::filesystem::path own_pipeline() { return std::filesystem::path(PIAE_SOURCE) / "pipeline"; }

/// The folder pipeline/ of a project.
struct Project {
  Folder folder;

  explicit Project(const std::string& protocol) { folder.write("protocol.toml", protocol); }

  /// Returns the contents of a settings file without the line that names its source.
  [[nodiscard]] std::string values_of(const std::string& stage,
                                      const std::string& variant = "") const {
    const Experiment experiment = read_experiment(folder.path());
    return values_in(*StageSettings(experiment, "run").of(stage, variant));
  }
  [[nodiscard]] static std::string values_in(const Settings& settings) {
    return settings.text.substr(settings.text.find('\n') + 1);
  }
};

TEST(SettingsOfAStage, AreThoseOfItsVariant) {
  const Project project(
      "[train]\nepochs = 200 # of them\n[train.vae]\nlearning-rate = 0.5\nepochs = 3\n"
      "[train.ae]\nlike = \"vae\"\nkeep = \"final\"\n");
  EXPECT_EQ(project.values_of("train", "vae"), "epochs = 3\nlearning-rate = 0.5\n");
  EXPECT_EQ(project.values_of("train", "ae"), "epochs = 3\nkeep = 'final'\nlearning-rate = 0.5\n");
  EXPECT_EQ(project.values_of("train", "smote"), "epochs = 200\n");
  EXPECT_EQ(project.values_of("score"), "\n");
}

TEST(SettingsOfAStage, LetADescriptionOverrideTheSplit) {
  const Project project("[split]\nwindow = 1024\nguard-windows = 2\n");
  project.folder.write("datasets/a.toml", "name = \"a\"\n[split]\nwindow = 4096\n");
  project.folder.write("datasets/b.toml", "name = \"b\"\nlike = \"a\"\n[split]\nmax-stride = 9\n");
  const Experiment experiment = read_experiment(project.folder.path());
  const auto settings = StageSettings(experiment, "run").of_split(*experiment.find("b"));
  EXPECT_EQ(settings->file, "run/.settings/split.b.toml");
  EXPECT_EQ(Project::values_in(*settings), "guard-windows = 2\nmax-stride = 9\nwindow = 4096\n");
}

TEST(SettingsOfAStage, ResolveADescriptionThatExtendsAnother) {
  const Project project("");
  project.folder.write("datasets/a.toml",
                       "name = \"a\"\nrate = 3\n[[record]]\nfile = \"2.mat\"\n[[record]]\nfile = "
                       "\"1.mat\"\n[[record]]\nfile = [\"2.mat\", \"x_*.csv\"]\n");
  project.folder.write("datasets/b.toml", "name = \"b\"\nlike = \"a\"\nrate = 4\n");
  const Experiment experiment = read_experiment(project.folder.path());
  const auto settings = StageSettings(experiment, "run").description(*experiment.find("b"));
  EXPECT_THAT(settings->text, HasSubstr("name = 'b'\nrate = 4\n"));
  EXPECT_THAT(settings->recordings, ElementsAre("1.mat", "2.mat", "x_*.csv"));
}

TEST(SettingsOfAStage, GiveTheSameFromTheirFileAsFromTheProtocol) {
  const Experiment experiment = read_experiment(own_pipeline());
  StageSettings settings(experiment, "run");
  for (const std::string& method : augment::method_names()) {
    const toml::table stored = toml::parse(settings.of("train", method)->text);
    EXPECT_EQ(cli::options_of(stored, "train", method),
              cli::options_of(experiment.protocol, "train", method))
        << method;
  }
}

TEST(SettingsOfAStage, KeepEveryBitOfANumber) {
  const auto back = [](double number) {
    std::ostringstream text;
    text << toml::toml_formatter(toml::table{{"x", number}});
    return toml::parse(text.str())["x"].value<double>();
  };
  Stream random("settings");
  for (int i = 0; i < 20000; ++i) {
    const double number =
        std::ldexp(random.normal(0, 1), static_cast<int>(random.below(200)) - 100);
    ASSERT_EQ(back(number), number);
  }
  for (const double number : {1e8, 0.1, 5e-324, 1.7976931348623157e308, -0.0, 100.0}) {
    ASSERT_EQ(back(number), number);
    ASSERT_EQ(std::signbit(*back(number)), std::signbit(number));
  }
}

TEST(SettingsFiles, AreWrittenIfChangedAndNotThroughLinks) {
  SmallRun run;
  run.request.run = "settings-test";
  const Folder here;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(here.path());
  std::filesystem::create_directory("elsewhere");
  const std::filesystem::path folder = "results/settings-test/.settings";
  write_settings(run.plan("cells"));
  EXPECT_THAT(bytes_of(folder / "train.smote.toml"), HasSubstr("\nneighbours = 4\n"));
  const auto long_ago = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  std::filesystem::last_write_time(folder / "train.smote.toml", long_ago);
  write_settings(run.plan("cells"));
  EXPECT_EQ(std::filesystem::last_write_time(folder / "train.smote.toml"), long_ago);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory_symlink(here / "elsewhere", folder);
  EXPECT_ERROR(write_settings(run.plan("cells")), Exit::failed, ".settings: is a link");
  EXPECT_TRUE(std::filesystem::is_empty("elsewhere"));
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace piae::plan
