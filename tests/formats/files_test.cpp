#include "formats/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/csv.hpp"
#include "formats/exported_windows.hpp"
#include "support/errors.hpp"

namespace piae::formats {
namespace {

using testing::ElementsAre;

TEST(ExportedFiles, HaveTheFormatOfTheirEnding) {
  EXPECT_THAT(paths_of("a/E.csv"), ElementsAre("a/E.csv"));
  EXPECT_THAT(paths_of("E.mat"), ElementsAre("E.mat"));
  EXPECT_THAT(paths_of("a/E.npy"), ElementsAre("a/E.npy", "a/E.labels.csv"));
  EXPECT_THAT(paths_of("E.wav"), ElementsAre("E.wav", "E.labels.csv"));
  const auto text_begins = [](const std::filesystem::path& path, const std::string& words) {
    return files_of(exported_windows(), path).front().text.starts_with(words);
  };
  EXPECT_TRUE(text_begins("E.csv", "dataset,"));
  EXPECT_TRUE(text_begins("E.mat", "MATLAB 5.0"));
  EXPECT_TRUE(text_begins("E.npy", "\x93NUMPY"));
  EXPECT_TRUE(text_begins("E.wav", "RIFF"));
  const auto files = files_of(exported_windows(), "E.npy");
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files.back().text, labels_csv(exported_windows()));
}

TEST(ExportedFiles, MustHaveAKnownEnding) {
  for (const char* path : {"E.xlsx", "E", "E.CSV", "folder.csv/"}) {
    EXPECT_ERROR(paths_of(path), Exit::usage, ".csv, .mat, .npy or .wav");
  }
}

}  // namespace
}  // namespace piae::formats
