#include "plan/planned.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>

#include "plan/settings_files.hpp"
#include "support/folder.hpp"

namespace piae::plan {
namespace {

namespace fs = std::filesystem;

const char* const protocol =
    "[split]\nwindow = 1024\n[train]\n[train.smote]\nneighbours = 4\n[generate]\n[score]\n"
    "[diagnose]\nepochs = 50\n[tabulate]\n";
const std::string table_step = "results/t/made/tabulate";

/// A project on the disk, the working folder of this process, with the files of its table.
class TableOnTheDisk : public testing::Test {
 protected:
  TableOnTheDisk() : before_(fs::current_path()) {
    folder_.write("pipeline/datasets/made.toml", "name = \"made\"\n[simulation]\nnoise = 0.1\n");
    set("");
    folder_.write("results/published/table.csv", "1\n");
    fs::current_path(folder_.path());
    request_.run = "t";
    request_.goals = {"tables"};
    request_.datasets = "made";
    request_.methods = "smote";
    request_.ratios = "10to1";
    request_.seeds = "0";
    Planned planned(request_, {});
    write_settings(planned.plan());
    const Graph& graph = planned.plan().graph();
    for (const std::string& file : graph.at(*graph.maker_of("results/t/made/tables.md")).outputs) {
      folder_.write(file, "a table\n");
    }
    begin();
  }
  ~TableOnTheDisk() override { fs::current_path(before_); }

  void set(const std::string& of_tabulate) {
    folder_.write("pipeline/protocol.toml", protocol + of_tabulate);
  }
  /// Writes the log of a step that starts now.
  void begin() {
    const auto now =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch());
    folder_.write(table_step + ".log", "build/bin/tabulate\nstep: started at " +
                                           std::to_string(now.count() + 0.05) + "\n");
  }
  /// Records how the table was made. True if the journal has kept it.
  bool notes() {
    const auto planned = planned_for(request_, {}, table_step);
    planned->note(table_step);
    planned->save();
    return artefact::Journal("results/t").step(table_step) != nullptr;
  }

  fs::path before_;
  Folder folder_;
  Request request_;
};

TEST_F(TableOnTheDisk, IsRecordedWithItsSettings) { EXPECT_TRUE(notes()); }

TEST_F(TableOnTheDisk, IsRecordedIfAnotherGoalNeedsMoreDataSets) {
  folder_.write("pipeline/datasets/other.toml", "name = \"other\"\n[simulation]\nnoise = 0.1\n");
  set("[transfer.both]\ndatasets = [\"made\", \"other\"]\nagainst = \"smote\"\n"
      "inputs = [\"smote=wdcnn\"]\n");
  request_.goals = {"transfer", "tables"};
  request_.datasets = "made other";
  write_settings(Planned(request_, {}).plan());
  begin();
  EXPECT_TRUE(notes());
  const std::string cell = "results/t/other/seed0/smote/10to1/wdcnn/diagnose";
  EXPECT_TRUE(planned_for(request_, {}, cell)->is_due(cell));
}

TEST_F(TableOnTheDisk, IsNotRecordedIfItsSettingsChangedMeanwhile) {
  set("against = \"none\"\n");
  EXPECT_FALSE(notes());
}

TEST_F(TableOnTheDisk, IsNotRecordedIfAnotherMakeWroteTheSettings) {
  set("against = \"none\"\n");
  ::usleep(100'000);
  write_settings(Planned(request_, {}).plan());
  EXPECT_FALSE(notes());
  begin();  // remade
  EXPECT_TRUE(notes());
}

TEST(FilesReadByAStep, CountAsChangedSinceItStarted) {
  const Times times{.started_s = 100, .now_s = 200};
  EXPECT_FALSE(lies_in(times, 99));
  EXPECT_TRUE(lies_in(times, 150));
  EXPECT_FALSE(lies_in(times, 3700));  // the clock was set back by an hour
}

}  // namespace
}  // namespace piae::plan
