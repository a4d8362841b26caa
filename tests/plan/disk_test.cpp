#include "plan/disk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "artefact/writer.hpp"
#include "support/folder.hpp"

namespace piae::plan {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// The folder of a run with one artefact.
class FilesOfARun : public testing::Test {
 protected:
  FilesOfARun() { write(1); }

  void write(double value) const {
    artefact::Writer writer("score");
    writer.attribute("/", "value", value);
    writer.save(file_,
                {.program = "score",
                 .options = "a = \"1\"\n",
                 .inputs = {{.role = "real", .file = "D.h5", .digest = std::string(64, 'd')}}});
  }
  /// Returns the file as a new process sees it.
  [[nodiscard]] std::optional<File> seen() const {
    RealDisk disk({folder_.path().string()}, true);
    const File* const file = disk.find(file_);
    const auto found = file == nullptr ? std::nullopt : std::optional(*file);
    disk.save();
    return found;
  }
  [[nodiscard]] std::string journal() const { return (folder_ / ".journal").string(); }

  Folder folder_;
  std::string file_ = (folder_ / "score.h5").string();
};

TEST_F(FilesOfARun, RecordHowTheyWereMade) {
  const auto file = seen();
  ASSERT_TRUE(file && file->made);
  EXPECT_EQ(*file->made->options, "a = \"1\"\n");
  EXPECT_THAT(file->made->inputs, ElementsAre(artefact::MadeFrom{"real", std::string(32, 'd')}));
  EXPECT_EQ(file->belongs_in, "score.h5");
  EXPECT_EQ(file->problem, "");
  std::filesystem::remove(file_);
  EXPECT_FALSE(seen());
}

TEST_F(FilesOfARun, RecordTheFileTheyBelongIn) {
  const auto expect = [&](const std::string& name, artefact::Writer& writer) {
    writer.save(file_, {});
    EXPECT_EQ(seen()->belongs_in, name);  // read from the file
    EXPECT_EQ(seen()->belongs_in, name);  // read from the journal
  };
  artefact::Writer windows("windows");
  windows.attribute("/", "role", std::string("C"));
  expect("C.h5", windows);
  artefact::Writer features("diagnosis");
  features.group("/features");
  expect("features.h5", features);
}

TEST_F(FilesOfARun, AreNotReadAgainIfUntouched) {
  const auto before = seen();
  // A digest that the file does not have shows that the journal was used.
  std::string text = bytes_of(journal());
  text.replace(text.find(before->digest), before->digest.size(), std::string(32, 'x'));
  std::ofstream(journal()) << text;
  EXPECT_EQ(seen()->digest, std::string(32, 'x'));
  std::filesystem::remove(journal());
  EXPECT_EQ(seen()->digest, before->digest);
}

TEST_F(FilesOfARun, AreReadAgainIfReplacedWithTheSameTime) {
  const auto before = seen();
  const auto time = std::filesystem::last_write_time(file_);
  write(2);
  std::filesystem::last_write_time(file_, time);
  EXPECT_NE(seen()->digest, before->digest);
}

TEST_F(FilesOfARun, ReportWhatIsWrongWithThem) {
  std::string bytes = bytes_of(file_);
  bytes[bytes.size() / 2] ^= 1;
  std::ofstream(file_, std::ios::binary) << bytes;
  const auto damaged = seen();
  ASSERT_TRUE(damaged);
  EXPECT_FALSE(damaged->made);
  EXPECT_THAT(damaged->problem, HasSubstr("score.h5: "));
  std::ofstream(file_) << "no artefact";
  EXPECT_THAT(seen()->problem, HasSubstr("not an HDF5 file"));
}

TEST_F(FilesOfARun, AreTheSameIfManyAreReadTogether) {
  std::vector<std::string> files{file_, (folder_ / "nowhere.h5").string()};
  for (const std::string name : {"a", "b", "c"}) {
    files.push_back((folder_ / (name + ".h5")).string());
    std::filesystem::copy_file(file_, files.back());
  }
  std::string bytes = bytes_of(files[3]);
  bytes[bytes.size() / 2] ^= 1;
  std::ofstream(files[3], std::ios::binary) << bytes;

  RealDisk disk({folder_.path().string()}, true);
  disk.read_ahead(files);
  disk.save();
  EXPECT_EQ(disk.find(files[1]), nullptr);
  EXPECT_THAT(disk.find(files[3])->problem, HasSubstr("b.h5: "));
  const std::string digest = disk.find(file_)->digest;
  const artefact::Journal journal(folder_.path());
  EXPECT_EQ(journal.file(files[3]), nullptr);
  for (const std::size_t good : {0, 2, 4}) {
    EXPECT_EQ(disk.find(files[good])->digest, digest);
    ASSERT_NE(journal.file(files[good]), nullptr);
    EXPECT_EQ(journal.file(files[good])->digest, digest);
  }
}

TEST_F(FilesOfARun, AreFoundBelowAFolderExceptHiddenOnes) {
  folder_.write("a/b/c.csv", "1");
  folder_.write(".jobs/d", "1");
  RealDisk disk({folder_.path().string()}, false);
  EXPECT_THAT(disk.files_below(folder_.path().string()), ElementsAre("a/b/c.csv", "score.h5"));
  EXPECT_THAT(disk.files_below((folder_ / "nowhere").string()), ElementsAre());
}

TEST_F(FilesOfARun, WriteNoJournalForReadOnlyGoals) {
  RealDisk disk({folder_.path().string()}, false);
  EXPECT_NE(disk.find(file_), nullptr);
  disk.save();
  EXPECT_FALSE(std::filesystem::exists(journal()));
}

TEST_F(FilesOfARun, NameTheRecordingsOfRecords) {
  artefact::Writer writer("records");
  writer.numbers("/records/one", std::vector<double>{1, 2});
  writer.attribute("/records/one", "source", std::string("1.mat"));
  writer.attribute("/records/one", "source_sha256", std::string(64, 's'));
  const std::string records = (folder_ / "records.h5").string();
  writer.save(records, {.program = "ingest", .options = "", .inputs = {}});
  RealDisk disk({folder_.path().string()}, false);
  const File* const file = disk.find(records);
  ASSERT_TRUE(file != nullptr && file->made) << (file ? file->problem : "");
  EXPECT_THAT(file->made->inputs,
              Contains(artefact::MadeFrom{"recording 1.mat", std::string(32, 's')}));
}

}  // namespace
}  // namespace piae::plan
