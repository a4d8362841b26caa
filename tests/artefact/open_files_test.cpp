#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

namespace piae::artefact {
namespace {

namespace fs = std::filesystem;

fs::path numbered(std::int64_t number) {
  return fs::path(testing::TempDir()) / ("open_files_" + std::to_string(number) + ".h5");
}

// HDF5 treats two files in memory with the same name as one file.
TEST(OpenFiles, AreReadIndependently) {
  for (const std::int64_t number : {1, 2}) {
    Writer writer("model");
    writer.attribute("/", "number", number);
    writer.save(numbered(number), {});
  }
  const Reader one(numbered(1), "model");
  const Reader two(numbered(2), "model");
  EXPECT_EQ(one.integer("/", "number"), 1);
  EXPECT_EQ(two.integer("/", "number"), 2);
}

TEST(OpenFiles, AreWrittenIndependently) {
  Writer one("model");
  Writer two("model");
  one.attribute("/", "number", std::int64_t{1});
  two.attribute("/", "number", std::int64_t{2});
  one.save(numbered(1), {});
  two.save(numbered(2), {});
  EXPECT_EQ(Reader(numbered(1), "model").integer("/", "number"), 1);
  EXPECT_EQ(Reader(numbered(2), "model").integer("/", "number"), 2);
}

// HDF5 looks in the working folder for a file with the name of one in memory, and opens it.
TEST(OpenFiles, DoNotComeFromTheWorkingFolder) {
  Writer writer("model");
  writer.attribute("/", "number", std::int64_t{1});
  writer.save(numbered(1), {});
  const fs::path before = fs::current_path();
  const fs::path folder = fs::path(testing::TempDir()) / "open_files";
  fs::create_directories(folder);
  for (int i = 1; i < 100; ++i) {
    // Opening it blocks, since a writer never comes.
    ASSERT_EQ(::mkfifo((folder / ("artefact-" + std::to_string(i))).c_str(), 0600), 0);
  }
  fs::current_path(folder);
  ::alarm(10);
  EXPECT_EQ(Reader(numbered(1), "model").integer("/", "number"), 1);
  ::alarm(0);
  fs::current_path(before);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace piae::artefact
