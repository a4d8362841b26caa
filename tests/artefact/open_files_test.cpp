#include <gtest/gtest.h>

#include <filesystem>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

namespace piae::artefact {
namespace {

namespace fs = std::filesystem;

fs::path numbered(std::int64_t number) {
  return fs::path(testing::TempDir()) / ("open_files_" + std::to_string(number) + ".h5");
}

// HDF5 takes two files in memory of one name for the same file.
TEST(OpenFiles, ReadersThatLiveTogetherReadTheirOwnFiles) {
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

TEST(OpenFiles, WritersThatLiveTogetherWriteTheirOwnFiles) {
  Writer one("model");
  Writer two("model");
  one.attribute("/", "number", std::int64_t{1});
  two.attribute("/", "number", std::int64_t{2});
  one.save(numbered(1), {});
  two.save(numbered(2), {});
  EXPECT_EQ(Reader(numbered(1), "model").integer("/", "number"), 1);
  EXPECT_EQ(Reader(numbered(2), "model").integer("/", "number"), 2);
}

}  // namespace
}  // namespace piae::artefact
