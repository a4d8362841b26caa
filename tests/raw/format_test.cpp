#include "raw/format.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::raw {
namespace {

using testing::ElementsAre;

TEST(Formats, DefaultToTextUnlessTheFirstBytesDiffer) {
  const Folder folder;
  for (const char* name : {"a.csv", "a.txt", "a.dat", "a.ASC", "2004.02.12.10.32.39", "a"}) {
    EXPECT_THAT(read_here(folder.write(name, "0.5\n1.5\n"), "1"), ElementsAre(0.5, 1.5)) << name;
  }
}

TEST(Formats, OfAMatFileMayBeText) {
  const Folder folder;
  const std::string ascii = "  -5.0000000e-01   1.0000000e+00\n   1.5000000e+00   2.0000000e+00\n";
  EXPECT_THAT(read_here(folder.write("a.mat", ascii), "1"), ElementsAre(-0.5, 1.5));  // save -ascii
  const std::string octave =
      "# Created by Octave 7.3.0\n# name: x\n# type: matrix\n# rows: 2\n# columns: 1\n 0.5\n "
      "1.5\n\n\n";
  EXPECT_THAT(read_here(folder.write("a.mat", octave), "1"), ElementsAre(0.5, 1.5));
  EXPECT_ERROR(read_here(folder.write("a.mat", octave + "# name: y\n 2\n"), "1"), Exit::bad_input,
               "a.mat, line 8: column 1 holds ''");
  for (const std::string& bytes : {std::string(), std::string("MATLAB 5.0 MBT-file\0\1", 21)}) {
    EXPECT_ERROR(read_here(folder.write("a.mat", bytes), "x"), Exit::bad_input,
                 "truncated, damaged or not a MATLAB file of version 5 or 7.3");
  }
}

TEST(Formats, AreRefusedWithAConversionIfUnsupported) {
  const Folder folder;
  const std::vector<std::pair<std::string, std::string>> files{
      {std::string("PK\x03\x04\x14\x00\x06\x00rest", 12),
       "is an Excel workbook: save the sheet as CSV"},
      {std::string("PK\x03\x04\x00\x00rest", 10),
       "is a zip archive (.zip, .npz) or an Excel workbook"},
      {"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "is an Excel workbook from before 2007"},
      {"\x1f\x8b\x08rest", "is compressed with gzip: unpack it (gunzip)"},
      {".snd" + std::string(40, '\0'),
       "is sound in an unsupported format; convert it: sox FILE OUT.wav"},
      {"ID3\x03" + std::string(40, '\0'), "is sound with lossy compression"},
      {"\xff\xfb\x90\x64" + std::string(40, '\0'), "is sound with lossy compression"},
      {std::string("\0\0\0\x20", 4) + "ftypM4A rest", "is sound with lossy compression"},
      {"OggSrest", "is sound with lossy compression"},
      {"MDF     4.10    ", "is an MDF file (ASAM): export the channel as CSV"},
      {"PAR1rest", "is a table in Parquet or Arrow: save it as CSV"},
      {"SQLite format 3", "is an SQLite database: export the samples as CSV"},
      {"\x80\x04\x95rest", "is a Python pickle: save the array with np.save"},
      {"<?xml version=\"1.0\"?>\n<a>1</a>\n", "is XML or HTML"},
      {"{\"t\":0,\"x\":0.5}\n", "is JSON: write the samples as CSV"},
      {"[{\"t\":0,\"x\":0.5}]\n", "is JSON: write the samples as CSV"},
      {"PK\x03\x04" + std::string(26, 'x') +
           "mimetypeapplication/vnd.oasis.opendocument.spreadsheet",
       "is an OpenDocument spreadsheet: save the sheet as CSV"}};
  for (const auto& [bytes, why] : files) {
    EXPECT_ERROR(read_here(folder.write("a.csv", bytes), "1"), Exit::bad_input, "a.csv: " + why);
  }
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
  for (const char* name : {"a.mat", "a.wav", "a.csv"}) {
    EXPECT_ERROR(read_here(folder.write(name, pointer), "1"), Exit::bad_input,
                 "is a Git LFS pointer, not the recording: fetch it (git lfs pull)");
  }
  for (const std::size_t size : {20U, 1000U}) {  // of the tag without its header, in 7 bits a byte
    const std::string tag = std::string("ID3\3\0\0\0\0", 8) + static_cast<char>(size >> 7) +
                            static_cast<char>(size & 127) + std::string(size, 'x');
    EXPECT_ERROR(read_here(folder.write("a.flac", tag + "fLaC"), "1"), Exit::bad_input,
                 "is FLAC behind an ID3 tag; remove the tag: id3v2 --delete-all FILE");
    EXPECT_ERROR(read_here(folder.write("a.flac", tag + "\xff\xfb"), "1"), Exit::bad_input,
                 "is sound with lossy compression");
  }
  const std::string mat4("\0\0\0\0\x03\0\0\0\x01\0\0\0\0\0\0\0\x02\0\0\0x\0", 22);
  EXPECT_ERROR(read_here(folder.write("a.mat", mat4 + std::string(24, '\0')), "x"), Exit::bad_input,
               "is a MATLAB file of version 4: save it as version 5");
}

/// Uses binary samples without a header, and UTF-16 text without a byte order mark.
TEST(Formats, AreDistinguishedFromTextWithoutAMark) {
  const Folder folder;
  std::string floats;
  std::string shorts;
  std::string wide;
  for (int i = 0; i < 100; ++i) {
    const auto x = static_cast<float>(std::sin(i));
    const auto n = static_cast<std::int16_t>(20 * std::sin(i));
    floats.append(reinterpret_cast<const char*>(&x), sizeof x);
    shorts.append(reinterpret_cast<const char*>(&n), sizeof n);
    for (const char c : std::to_string(x) + '\n') wide += {c, '\0'};
  }
  for (const std::string& bytes : {floats, shorts}) {
    EXPECT_ERROR(read_here(folder.write("a.dat", bytes), "1"), Exit::bad_input,
                 "a.dat: is binary, in an unsupported format; export it as text");
  }
  EXPECT_ERROR(read_here(folder.write("a.txt", wide), "1"), Exit::bad_input,
               "a.txt: seems to be UTF-16 without a byte order mark");
  std::string squared;  // m/s²
  for (const char c : std::string("Zeit;m/s")) squared += {c, '\0'};
  squared += std::string("\xB2\0;\0", 4);
  EXPECT_ERROR(read_here(folder.write("a.txt", squared + wide), "1"), Exit::bad_input,
               "a.txt: seems to be UTF-16 without a byte order mark");
}

TEST(Formats, AreRefusedWithoutSamples) {
  const Folder folder;
  for (const char* text : {"", "\n", "x\n", "t,x\n", "# comment\n", "\xEF\xBB\xBF"}) {
    EXPECT_ERROR(read_here(folder.write("a.csv", text), "1"), Exit::bad_input,
                 "a.csv: 1 holds no sample");
  }
  EXPECT_ERROR(read_here(folder.write("a.csv", "t,x\n"), "x"), Exit::bad_input,
               "a.csv: x holds no sample");
}

TEST(Formats, MustMatchTheFileExtension) {
  const Folder folder;
  for (const char* name : {"a.wav", "a.npy", "a.h5", "a.flac"}) {
    EXPECT_ERROR(read_here(folder.write(name, "0.5\n1.5\n"), "1"), Exit::bad_input,
                 std::string(name) + ": truncated, damaged or not a '");
  }
}

}  // namespace
}  // namespace piae::raw
