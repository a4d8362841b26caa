#include "raw/format.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::raw {
namespace {

using testing::ElementsAre;

TEST(Formats, AreTextUnlessTheirFirstBytesSayOtherwise) {
  const Folder folder;
  for (const char* name : {"a.csv", "a.txt", "a.dat", "a.ASC", "2004.02.12.10.32.39", "a"}) {
    EXPECT_THAT(read_here(folder.write(name, "0.5\n1.5\n"), "1"), ElementsAre(0.5, 1.5)) << name;
  }
}

TEST(Formats, ThatAreNotReadAreNamedWithAWayOut) {
  const Folder folder;
  const std::vector<std::pair<std::string, std::string>> files{
      {std::string("PK\x03\x04\x14\x00\x06\x00rest", 12),
       "is an Excel workbook: save the sheet as CSV"},
      {std::string("PK\x03\x04\x00\x00rest", 10), "is a zip archive or an Excel workbook"},
      {"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "is an Excel workbook of before 2007"},
      {"\x1f\x8b\x08rest", "is packed by gzip: unpack it (gunzip)"},
      {"PK\x03\x04" + std::string(26, 'x') +
           "mimetypeapplication/vnd.oasis.opendocument.spreadsheet",
       "is an OpenDocument spreadsheet: save the sheet as CSV"}};
  for (const auto& [bytes, why] : files) {
    EXPECT_ERROR(read_here(folder.write("a.csv", bytes), "1"), Exit::bad_input, "a.csv: " + why);
  }
  const std::string mat4("\0\0\0\0\x03\0\0\0\x01\0\0\0\0\0\0\0\x02\0\0\0x\0", 22);
  EXPECT_ERROR(read_here(folder.write("a.mat", mat4 + std::string(24, '\0')), "x"), Exit::bad_input,
               "is of MATLAB, version 4: save it as version 5");
}

TEST(Formats, ThatTheNameSaysMustBeThere) {
  const Folder folder;
  for (const char* name : {"a.wav", "a.npy", "a.h5", "a.flac"}) {
    EXPECT_ERROR(read_here(folder.write(name, "0.5\n1.5\n"), "1"), Exit::bad_input,
                 std::string(name) + ": truncated, damaged or not what ");
  }
}

}  // namespace
}  // namespace piae::raw
