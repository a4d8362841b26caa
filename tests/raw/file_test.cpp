#include "raw/file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <matio.h>

#include <cmath>
#include <cstdint>

#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::raw {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

// CSV

TEST(Csv, ReadsAColumnByNumberOrName) {
  const Folder folder;
  const fs::path file = folder.write("a.csv", "time,acc\n0,1.5\n1,-2e-3\n2,3\n");
  EXPECT_THAT(read(file, "acc"), ElementsAre(1.5, -0.002, 3));
  EXPECT_THAT(read(file, "2"), ElementsAre(1.5, -0.002, 3));
  EXPECT_THAT(read(file, "time"), ElementsAre(0, 1, 2));
}

TEST(Csv, NeedsNeitherHeaderNorLastLineEnd) {
  const Folder folder;
  EXPECT_THAT(read_csv(folder.write("a.csv", "1\n2\n3"), "1"), ElementsAre(1, 2, 3));
}

TEST(Csv, AcceptsOtherSeparatorsLineEndsQuotesAndAByteOrderMark) {
  const Folder folder;
  const std::string text = "\xEF\xBB\xBF\"t\"; \"a b\"\r\n0; 4\r\n1; 5\r\n";
  EXPECT_THAT(read_csv(folder.write("a.csv", text), "a b"), ElementsAre(4, 5));
  EXPECT_THAT(read_csv(folder.write("b.csv", "1\t2\n3\t4\n"), "2"), ElementsAre(2, 4));
}

TEST(Csv, KeepsNaNAndGivesNoSamplesForAnEmptyFile) {
  const Folder folder;
  EXPECT_TRUE(std::isnan(read_csv(folder.write("a.csv", "1\nnan\n"), "1").at(1)));
  EXPECT_THAT(read_csv(folder.write("b.csv", ""), "1"), IsEmpty());
  EXPECT_THAT(read_csv(folder.write("c.csv", "acc\n"), "acc"), IsEmpty());
}

TEST(Csv, RefusesTextsThatAreNotColumnsOfNumbers) {
  const Folder folder;
  const auto read = [&](const std::string& text, const std::string& column) {
    return read_csv(folder.write("a.csv", text), column);
  };
  EXPECT_ERROR(read("t,a\n0,1\n1\n", "a"), Exit::bad_input, "line 3: has 1 field,");
  EXPECT_ERROR(read("t,a\n0,1\n\n1,2\n", "a"), Exit::bad_input, "line 3: is blank between");
  EXPECT_ERROR(read("t,a\n0,1\n1,x2\n", "a"), Exit::bad_input, "line 3: column a holds 'x2'");
  EXPECT_ERROR(read("t,a\n0,1\n1,2x\n", "a"), Exit::bad_input, "line 3: column a holds '2x'");
  EXPECT_ERROR(read("t,a\n0,1\n1,\n", "a"), Exit::bad_input, "line 3: column a holds ''");
  EXPECT_ERROR(read("t,a\n0,1\n0,1,5\n", "a"), Exit::bad_input, "line 3: has 3 fields");
  EXPECT_ERROR(read("t,a\n0,1\n", "b"), Exit::bad_input, "has no column b; it has t, a");
  EXPECT_ERROR(read("a,a\n0,1\n", "a"), Exit::bad_input, "has several columns a");
  std::string many = "x";
  for (int i = 0; i < 3000; ++i) many += ",x";
  EXPECT_ERROR(read(many + "\n", "b"), Exit::bad_input, "it has x, x, x, ");
  EXPECT_ERROR(read(many + "\n", "b"), Exit::bad_input, ", x and 2981 more");
  const std::string full(80, 'x');
  EXPECT_ERROR(read("a\n" + full + "\n", "a"), Exit::bad_input,
               "holds '" + full + "', not a number");
  EXPECT_ERROR(read("a\n" + full + "y\n", "a"), Exit::bad_input, "holds '" + full + "...', not");
  EXPECT_ERROR(read("t,a\n0,1\n", "3"), Exit::bad_input, "has no column 3; columns are 1 to 2");
  EXPECT_ERROR(read("t,a\n0,1\n", "0"), Exit::bad_input, "has no column 0");
}

TEST(Csv, DistinguishesNamesFromDamagedNumbers) {
  const Folder folder;
  const std::string damaged = std::string("0.") + '\x01' + "125\n1\n2\n";
  EXPECT_ERROR((void)read_csv(folder.write("a.csv", damaged), "1"), Exit::bad_input,
               "line 1: holds the control character 0x01");
  EXPECT_ERROR((void)read_csv(folder.write("b.csv", "--\n1\n"), "1"), Exit::bad_input, "line 1: ");
  EXPECT_THAT(read_csv(folder.write("c.csv", "t,[g]\n1,2\n"), "2"), ElementsAre(2));
}

TEST(Csv, SkipsTheTextAboveTheNumbers) {
  const Folder folder;
  const auto read = [&](const std::string& text, const std::string& column) {
    return read_csv(folder.write("a.csv", text), column);
  };
  // Comments, one of which names the columns.
  EXPECT_THAT(read("# made by a logger\n# t acc\n0 1.5\n1 2.5\n", "acc"), ElementsAre(1.5, 2.5));
  EXPECT_THAT(read("% made by acc\n0,1.5\n1,2.5\n", "2"), ElementsAre(1.5, 2.5));
  // Text and single numbers of an instrument, a header, units.
  const std::string logger =
      "Logger X200\nRate;12000\n\nTime;Acc\ns;m/s2\n0;1,5\n0,1;2\n0,2;-2,25\n";
  EXPECT_THAT(read(logger, "Acc"), ElementsAre(1.5, 2, -2.25));
  EXPECT_THAT(read(logger, "2"), ElementsAre(1.5, 2, -2.25));
  EXPECT_THAT(read("Channel,acc\nt,acc\n0,7\n1,8\n", "acc"), ElementsAre(7, 8));
  // The line number in an error counts all of these lines.
  EXPECT_ERROR(read(logger + "1;x\n", "Acc"), Exit::bad_input, "line 9: column Acc holds 'x'");
  EXPECT_ERROR(read(logger, "Force"), Exit::bad_input, "has no column Force; it has ");
  EXPECT_ERROR(read("0.5,1\n...\n1,2\n", "2"), Exit::bad_input, "line 2: has 1 field,");
  EXPECT_ERROR(read("words\n..;..\n1;2\n3;4\n", "2"), Exit::bad_input, "line 2: column 2 holds");
}

TEST(Csv, AcceptsDecimalCommasIfCommasDoNotSeparate) {
  const Folder folder;
  const auto read = [&](const std::string& text, const std::string& column) {
    return read_csv(folder.write("a.csv", text), column);
  };
  EXPECT_THAT(read("t;a\n0;1,5\n1;-2,5e-1\n", "a"), ElementsAre(1.5, -0.25));
  EXPECT_THAT(read("0\t1,5\n1\t2\n", "2"), ElementsAre(1.5, 2));
  EXPECT_THAT(read(" 0,1   2,5\n 0,2  -3,5 \n", "2"), ElementsAre(2.5, -3.5));
  EXPECT_THAT(read("1, 2\n3, 4\n", "2"), ElementsAre(2, 4));
  EXPECT_ERROR(read("1;1.234,5\n", "2"), Exit::bad_input, "holds '1.234,5', ");
  EXPECT_ERROR(read("1;1,234\n2;5.5\n", "2"), Exit::bad_input, "the other decimal sign");
  // Numbers split at a decimal comma are not samples.
  EXPECT_ERROR(read("1,25\n1,05\n", "2"), Exit::bad_input,
               "line 2: holds 1,05: the numbers seem to have decimal commas");
  EXPECT_ERROR(read("1,25\n-0,05\n", "1"), Exit::bad_input, "seem to have decimal commas");
  // If another field has a decimal point, commas separate the fields, and -0 is a number.
  EXPECT_EQ(read("-0,0.5\n1,0.25\n", "1"), (std::vector<double>{0, 1}));
}

TEST(Csv, MayBeATextFileOrInCapitals) {
  const Folder folder;
  EXPECT_THAT(read(folder.write("a.txt", "0 1\n1 2\n"), "2"), ElementsAre(1, 2));
  EXPECT_THAT(read(folder.write("A.CSV", "0,1\n1,2\n"), "2"), ElementsAre(1, 2));
}

std::string utf16(const std::string& text, bool low_byte_first) {
  std::string bytes;
  for (const char c : text) {
    bytes += low_byte_first ? std::string{c, '\0'} : std::string{'\0', c};
  }
  return bytes;
}

TEST(Csv, MayBeUtf16WithAByteOrderMark) {
  const Folder folder;
  const std::string text = "t;a\r\n0;1,5\r\n1;2\r\n";
  const fs::path little = folder.write("a.csv", "\xFF\xFE" + utf16(text, true));
  const fs::path big = folder.write("b.csv", "\xFE\xFF" + utf16(text, false));
  EXPECT_THAT(read_csv(little, "a"), ElementsAre(1.5, 2));
  EXPECT_THAT(read_csv(big, "a"), ElementsAre(1.5, 2));
  // m/s² in UTF-16 and in UTF-8.
  const std::string squared = "\xFF\xFE" + utf16("m/s", true) + "\xB2" +
                              utf16("\n", true).insert(0, 1, '\0') + utf16("1\n", true);
  EXPECT_THAT(read_csv(folder.write("c.csv", squared), "m/s²"), ElementsAre(1));
  EXPECT_ERROR((void)read_csv(folder.write("d.csv", utf16(text, true)), "a"), Exit::bad_input,
               "seems to be UTF-16 without a byte order mark; save it as UTF-8");
}

/// Returns a table of times and samples, with one sample in each line.
std::string timed_table(const std::string& line_end) {
  std::string text = "Time (s),acc" + line_end;
  for (int i = 0; i < 200; ++i) {
    text += std::to_string(i / 1000.0) + ',' + std::to_string(std::sin(i)) + line_end;
  }
  return text;
}

/// A crash while a file is written leaves a hole. Where the hole begins and ends between the same
/// two separators, its lines would vanish without a trace.
TEST(Csv, IsRefusedWithAHole) {
  const Folder folder;
  for (const char* line_end : {"\n", "\r\n", "\r"}) {
    const std::string whole = timed_table(line_end);
    const std::size_t begin = whole.find("0.100000,") + 4;
    const std::size_t end = whole.find("0.150000,") + 6;
    for (const char filling : {'\0', '\x01', '\x1a', '\x7f'}) {
      std::string text = whole;
      text.replace(begin, end - begin, end - begin, filling);
      for (const char* column : {"acc", "2", "Time (s)"}) {
        EXPECT_ERROR((void)read_csv(folder.write("a.csv", text), column), Exit::bad_input,
                     "a.csv, line 102: holds the control character 0x");
      }
      if (std::string(line_end) == "\r") continue;
      for (const bool low_byte_first : {true, false}) {
        const std::string mark = low_byte_first ? "\xFF\xFE" : "\xFE\xFF";
        EXPECT_ERROR(
            (void)read_csv(folder.write("a.csv", mark + utf16(text, low_byte_first)), "acc"),
            Exit::bad_input, "a.csv, line 102: holds the control character 0x");
      }
    }
    // Erased flash memory has other bytes.
    std::string text = whole;
    text.replace(begin, end - begin, end - begin, '\xff');
    EXPECT_ERROR((void)read_csv(folder.write("a.csv", text), "acc"), Exit::bad_input,
                 "a.csv, line 102: ");
  }
}

/// Loggers pad fields of a fixed length with nulls, or write escape sequences of terminals.
TEST(Csv, MayHaveControlCharactersAboveItsTable) {
  const Folder folder;
  const std::string title = std::string(80, 'x') + "\n";
  const std::string nulls(20, '\0');
  for (const std::string& line : {"Operator: Bob" + nulls, "Bob" + nulls + "Lab" + nulls,
                                  std::string("Note: \x1b[1mbold\x1b[0m")}) {
    for (const char* column : {"acc", "2"}) {
      const auto file = folder.write("a.csv", title + line + "\n" + timed_table("\n"));
      EXPECT_EQ(read_csv(file, column).size(), 200U) << line;
    }
  }
  // A hole that begins in the header, and ends within a row or is a block of a disk.
  for (const std::string& line : {"Operator: Bob" + nulls + "00,0.25",
                                  "Operator: Bob" + std::string(512, '\0'), nulls, nulls + "0.5"}) {
    for (const char* column : {"acc", "2"}) {
      const auto file = folder.write("a.csv", title + line + "\n" + timed_table("\n"));
      EXPECT_ERROR((void)read_csv(file, column), Exit::bad_input,
                   "a.csv, line 2: holds the control character 0x00, as after a crash, so lines "
                   "may be missing; remove the characters, or get the file again");
    }
  }
  // A word at the end of a row.
  std::string rows = "t,acc,state\n";
  for (int i = 0; i < 20; ++i) rows += "0.1,0.5,good\n";
  rows.replace(rows.find("good\n", 100), 20, 20, '\0');
  EXPECT_ERROR((void)read_csv(folder.write("a.csv", rows), "acc"), Exit::bad_input,
               "holds the control character 0x00");
}

TEST(Csv, IsRefusedIfATimeIsNotANumber) {
  const Folder folder;
  std::string text = timed_table("\n");
  const auto read = [&] { return read_csv(folder.write("a.csv", text), "acc"); };
  text.replace(text.find("0.100000,"), 8, "0.10?000");
  EXPECT_ERROR((void)read(), Exit::bad_input,
               "a.csv, line 102: holds the time '0.10?000', which is not a number");
  // Some loggers write the time once for several samples, or the time of day.
  text.replace(text.find("0.10?000"), 8, "");
  EXPECT_EQ(read().size(), 200U);
  text = "t,acc\n59.9,1\n1:00.0,2\n1:00.1,3\n";
  EXPECT_THAT(read(), ElementsAre(1, 2, 3));
  // Times of another form in a few lines are left out.
  for (const char* other : {"1:00.00", "12:00:00", "2024-02-24 10:00:00", "-", "--"}) {
    text = timed_table("\n");
    text.replace(text.find("0.100000,"), 8, other);
    EXPECT_EQ(read().size(), 200U) << other;
  }
  text = "time;acc\n";
  for (int i = 0; i < 20; ++i) text += std::to_string(990 + i) + ".5;1\n";
  text.replace(text.find("1000.5"), 1, "1,");
  EXPECT_EQ(read().size(), 20U);
}

// Storing lines or fields one by one would take many times the file's size.
TEST(Csv, UsesNoMoreMemoryThanTheFileSizeAllows) {
  const Folder folder;
  const std::string lines = "1\n" + std::string(30'000'000, '\n') + "2\n";
  EXPECT_ERROR((void)read(folder.write("lines.csv", lines), "1"), Exit::bad_input,
               "line 2: column 1 holds ''");
  const std::string fields(30'000'000, ',');
  EXPECT_ERROR((void)read(folder.write("fields.csv", fields), "1"), Exit::bad_input,
               "line 1: has more than 10000 columns");
}

// MATLAB

struct MatVariable {
  const char* name;
  matio_classes class_type;
  matio_types data_type;
  std::vector<std::size_t> dims;
  const void* data;
};

fs::path write_mat(const fs::path& file, mat_ft version, const std::vector<MatVariable>& variables,
                   matio_compression compression = MAT_COMPRESSION_NONE) {
  mat_t* mat = Mat_CreateVer(file.c_str(), nullptr, version);
  for (MatVariable v : variables) {
    matvar_t* variable =
        Mat_VarCreate(v.name, v.class_type, v.data_type, static_cast<int>(v.dims.size()),
                      v.dims.data(), const_cast<void*>(v.data), 0);
    EXPECT_EQ(Mat_VarWrite(mat, variable, compression), 0);
    Mat_VarFree(variable);
  }
  Mat_Close(mat);
  return file;
}

const std::vector<double> doubles{1.5, -2, 3e-9};

class Mat : public testing::TestWithParam<mat_ft> {};

TEST_P(Mat, ReadsRealVectorsOfAnyNumberType) {
  const Folder folder;
  const std::vector<float> floats{0.5F, 1};
  const std::vector<std::int16_t> shorts{-32768, 7};
  const fs::path file = write_mat(folder / "a.mat", GetParam(),
                                  {{"column", MAT_C_DOUBLE, MAT_T_DOUBLE, {3, 1}, doubles.data()},
                                   {"row", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 3}, doubles.data()},
                                   {"single", MAT_C_SINGLE, MAT_T_SINGLE, {2, 1}, floats.data()},
                                   {"int16", MAT_C_INT16, MAT_T_INT16, {2, 1}, shorts.data()}});
  EXPECT_EQ(read(file, "column"), doubles);
  EXPECT_EQ(read(file, "row"), doubles);
  EXPECT_THAT(read(file, "single"), ElementsAre(0.5, 1));
  EXPECT_THAT(read(file, "int16"), ElementsAre(-32768, 7));
}

TEST_P(Mat, ListsVariablesIfTheRequestedOneIsMissing) {
  const Folder folder;
  const fs::path file =
      write_mat(folder / "a.mat", GetParam(),
                {{"X098_DE", MAT_C_DOUBLE, MAT_T_DOUBLE, {3, 1}, doubles.data()},
                 {"X099_DE", MAT_C_DOUBLE, MAT_T_DOUBLE, {3, 1}, doubles.data()}});
  EXPECT_ERROR(read_mat(file, "X097_DE"), Exit::bad_input,
               "a.mat: has no variable X097_DE; it has X098_DE, X099_DE");
}

TEST_P(Mat, RefusesAMatrixAndText) {
  const Folder folder;
  const std::vector<double> four{1, 2, 3, 4};
  const fs::path file = write_mat(folder / "a.mat", GetParam(),
                                  {{"m", MAT_C_DOUBLE, MAT_T_DOUBLE, {2, 2}, four.data()},
                                   {"t", MAT_C_CHAR, MAT_T_UINT8, {1, 3}, "abc"}});
  EXPECT_ERROR(read_mat(file, "m"), Exit::bad_input, "variable m is not a vector");
  EXPECT_ERROR(read_mat(file, "t"), Exit::bad_input, "variable t does not hold numbers");
}

INSTANTIATE_TEST_SUITE_P(Versions, Mat, testing::Values(MAT_FT_MAT5, MAT_FT_MAT73),
                         [](const auto& info) { return info.param == MAT_FT_MAT5 ? "v5" : "v73"; });

TEST(MatFile, IsRefusedIfTruncatedAnywhere) {
  const Folder folder;
  std::vector<double> noise(3000);
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = std::sin(static_cast<double>(i * i));
  const std::vector<std::pair<mat_ft, matio_compression>> kinds{
      {MAT_FT_MAT5, MAT_COMPRESSION_NONE},
      {MAT_FT_MAT5, MAT_COMPRESSION_ZLIB},
      {MAT_FT_MAT73, MAT_COMPRESSION_NONE}};
  for (const auto& [version, compression] : kinds) {
    const fs::path file =
        write_mat(folder / "a.mat", version,
                  {{"x", MAT_C_DOUBLE, MAT_T_DOUBLE, {3000, 1}, noise.data()}}, compression);
    EXPECT_EQ(read_mat(file, "x"), noise);
    const std::uintmax_t whole = fs::file_size(file);
    for (const std::uintmax_t size : {whole - 8, whole / 2, std::uintmax_t{200},
                                      std::uintmax_t{128}, std::uintmax_t{50}, std::uintmax_t{0}}) {
      fs::resize_file(file, size);
      EXPECT_ERROR(read_mat(file, "x"), Exit::bad_input, "a.mat");
    }
    fs::remove(file);
  }
}

TEST(MatFile, IsRefusedIfItHasAnotherFormat) {
  const Folder folder;
  EXPECT_ERROR(read_mat(folder.write("a.mat", "<html>404</html>"), "x"), Exit::bad_input,
               "not a MATLAB file");
}

// HDF5

void write_dataset(hid_t file, const char* name, hid_t type, const std::vector<hsize_t>& dims,
                   const void* data) {
  const hid_t space = H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr);
  const hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  EXPECT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), 0);
  H5Dclose(set);
  H5Sclose(space);
}

fs::path write_hdf5(const fs::path& path) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const std::vector<float> floats{0.5F, 1, 2, 3};
  const std::vector<std::int32_t> integers{-7, 8};
  H5Gclose(H5Gcreate2(file, "raw", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  write_dataset(file, "raw/acc", H5T_NATIVE_FLOAT, {4}, floats.data());
  write_dataset(file, "raw/matrix", H5T_NATIVE_FLOAT, {2, 2}, floats.data());
  write_dataset(file, "column", H5T_NATIVE_FLOAT, {4, 1}, floats.data());
  write_dataset(file, "counts", H5T_STD_I32BE, {2}, integers.data());
  const hid_t text = H5Tcopy(H5T_C_S1);
  write_dataset(file, "text", text, {4}, "abcd");
  H5Tclose(text);
  H5Fclose(file);
  return path;
}

TEST(Hdf5, ReadsFloatsAndIntegersOfAnyByteOrder) {
  const Folder folder;
  const fs::path file = write_hdf5(folder / "a.h5");
  EXPECT_THAT(read(file, "/raw/acc"), ElementsAre(0.5, 1, 2, 3));
  EXPECT_THAT(read(file, "raw/acc"), ElementsAre(0.5, 1, 2, 3));
  EXPECT_THAT(read(file, "column"), ElementsAre(0.5, 1, 2, 3));
  // The bytes of -7 and 8 in this machine's order, read as big-endian numbers.
  EXPECT_THAT(read(file, "counts"), ElementsAre(-100663297, 134217728));
}

TEST(Hdf5, RefusesDatasetsThatAreNotVectorsOfNumbers) {
  const Folder folder;
  const fs::path file = write_hdf5(folder / "a.hdf5");
  EXPECT_ERROR(read(file, "acc"), Exit::bad_input,
               "has no dataset /acc; it has /column, /counts, /raw/acc, /raw/matrix, /text");
  EXPECT_ERROR(read(file, "raw"), Exit::bad_input, "has no dataset /raw");
  EXPECT_ERROR(read(file, "raw/matrix"), Exit::bad_input, "is not a vector");
  EXPECT_ERROR(read(file, "text"), Exit::bad_input, "does not hold numbers");
}

TEST(Hdf5, RefusesATruncatedFile) {
  const Folder folder;
  const fs::path file = write_hdf5(folder / "a.h5");
  fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_ERROR(read_hdf5(file, "raw/acc"), Exit::bad_input, "a.h5: truncated, damaged or not");
}

TEST(RawFile, IsRefusedIfItHoldsOneNumber) {
  const Folder folder;
  EXPECT_ERROR(read(folder.write("a.csv", "rpm\n1772\n"), "rpm"), Exit::bad_input,
               "rpm holds only one number, 1772; name the variable");
}

}  // namespace
}  // namespace piae::raw
