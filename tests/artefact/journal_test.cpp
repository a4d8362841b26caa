#include "artefact/journal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "base/error.hpp"
#include "support/folder.hpp"

namespace piae::artefact {
namespace {

using testing::ElementsAre;

const Provenance provenance{
    .program = "train",
    .options = "epochs = \"200\"\nname = \"a\\b\tc\"\n",
    .inputs = {{.role = "known", .file = "C.h5", .digest = std::string(64, 'a')},
               {.role = "recording", .file = "1 2.mat", .digest = std::string(64, 'b')}}};

/// A run with one file that the journal knows.
struct RunWithJournal {
  Folder folder;
  std::string file = (folder / "model.h5").string();

  RunWithJournal() {
    folder.write("model.h5", "content");
    add_to_journal(folder.path(), file, {std::string(64, 'd'), "model.h5"}, provenance);
  }
};

TEST(JournalOfARun, RecordsTheProvenanceOfAnArtefact) {
  const RunWithJournal run;
  const Journal journal(run.folder.path());
  const SeenFile* const seen = journal.file(run.file);
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(seen->stat, *stat_of(run.file));
  EXPECT_EQ(seen->digest, std::string(32, 'd'));
  EXPECT_EQ(seen->belongs_in, "model.h5");
  ASSERT_TRUE(seen->made);
  EXPECT_EQ(*seen->made->options, provenance.options);
  EXPECT_THAT(seen->made->inputs, ElementsAre(MadeFrom{"known", std::string(32, 'a')},
                                              MadeFrom{"recording 1 2.mat", std::string(32, 'b')}));
  EXPECT_EQ(journal.file((run.folder / "other.h5").string()), nullptr);
}

TEST(JournalOfARun, RecordsTheFilesOfAStep) {
  const Folder folder;
  const std::string step = (folder / "cwru/tabulate").string();
  Journal first(folder.path());
  const DoneStep done{.made = {std::make_shared<const std::string>("a = \"1\"\n"),
                               {{"cells", "12-abc"}, {"published tables", "3-def"}}},
                      .outputs = {{"results/t/cwru/tables.md", "123"}}};
  first.note(step, done);
  first.save();
  const Journal second(folder.path());
  const DoneStep* const read = second.step(step);
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(*read->made.options, "a = \"1\"\n");
  EXPECT_EQ(read->made.inputs, done.made.inputs);
  EXPECT_EQ(read->outputs, done.outputs);
}

TEST(JournalOfARun, UsesTheLastLine) {
  const RunWithJournal run;
  run.folder.write("model.h5", "another content");
  add_to_journal(run.folder.path(), run.file, {std::string(64, 'e'), "model.h5"}, provenance);
  EXPECT_EQ(Journal(run.folder.path()).file(run.file)->digest, std::string(32, 'e'));
}

TEST(JournalOfARun, LosesOnlyDamagedLines) {
  const RunWithJournal run;
  const std::string text = bytes_of(run.folder / ".journal");
  for (std::size_t size = 0; size < text.size(); ++size) {
    run.folder.write(".journal", text.substr(0, size));
    const Journal cut(run.folder.path());
    const SeenFile* const seen = cut.file(run.file);
    EXPECT_EQ(seen == nullptr ? std::string(32, 'd') : seen->digest, std::string(32, 'd')) << size;
    // lines after a cut-off line are read
    run.folder.write("E.h5", "windows");
    add_to_journal(run.folder.path(), run.folder / "E.h5", {std::string(64, 'f'), "E.h5"},
                   provenance);
    const Journal more(run.folder.path());
    ASSERT_NE(more.file((run.folder / "E.h5").string()), nullptr) << size;
  }
}

TEST(JournalOfARun, IsRefusedIfNotAFile) {
  const Folder folder;
  const std::filesystem::path place = folder.path() / ".journal";
  const auto expect_refusal = [&] {
    EXPECT_THROW(Journal{folder.path()}, Error);
    std::filesystem::remove(place);
  };
  std::filesystem::create_directory(place);
  expect_refusal();
  std::filesystem::create_symlink("elsewhere", place);
  expect_refusal();
  EXPECT_NO_THROW(Journal{folder.path()});
}

TEST(JournalOfARun, MovesWithTheRun) {
  const RunWithJournal run;
  run.folder.write("moved/.journal", bytes_of(run.folder / ".journal"));
  const std::filesystem::path moved = run.folder / "moved";
  EXPECT_NE(Journal(moved).file((moved / "model.h5").string()), nullptr);
}

TEST(JournalOfARun, StaysSmallAfterManyRebuilds) {
  const RunWithJournal run;
  for (int i = 0; i < 12000; ++i) {
    add_to_journal(run.folder.path(), run.file, {std::string(64, 'd'), "model.h5"}, provenance);
  }
  const auto before = std::filesystem::file_size(run.folder / ".journal");
  Journal journal(run.folder.path());
  journal.save();
  EXPECT_LT(std::filesystem::file_size(run.folder / ".journal"), before / 1000);
  EXPECT_NE(Journal(run.folder.path()).file(run.file), nullptr);
}

TEST(JournalOfARun, LosesNothingAddedDuringCompaction) {
  const Folder folder;
  Provenance large = provenance;
  large.options = "a = \"" + std::string(100'000, 'x') + "\"\n";
  constexpr int count = 400;
  std::atomic<bool> is_done = false;
  std::thread other([&] {
    while (!is_done) Journal(folder.path()).save();
  });
  for (int i = 0; i < count; ++i) {
    const auto file = folder.write("E" + std::to_string(i) + ".h5", "windows");
    add_to_journal(folder.path(), file, {std::string(64, 'd'), "E.h5"}, large);
  }
  is_done = true;
  other.join();
  const Journal journal(folder.path());
  for (int i = 0; i < count; ++i) {
    EXPECT_NE(journal.file((folder / ("E" + std::to_string(i) + ".h5")).string()), nullptr) << i;
  }
}

TEST(StatOfAFile, ChangesWithTheFile) {
  const Folder folder;
  folder.write("a", "1");
  const auto before = stat_of(folder / "a");
  folder.write("b", "2");
  std::filesystem::last_write_time(folder / "b", std::filesystem::last_write_time(folder / "a"));
  std::filesystem::rename(folder / "b", folder / "a");
  EXPECT_NE(stat_of(folder / "a"), before);
  EXPECT_FALSE(stat_of(folder / "nothing"));
  EXPECT_FALSE(stat_of(folder.path()));
}

}  // namespace
}  // namespace piae::artefact
