#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <tuple>

#include "stages/program.hpp"
#include "support/folder.hpp"
#include "support/harmful_files.hpp"

/// Outputs of read_raw: files, pipes, closed and full ones.
namespace piae::stages {
namespace {

using testing::HasSubstr;

/// An output in bash syntax, with % for the output's name.
struct Place {
  const char* name;
  const char* before;  ///< a line that creates it
  const char* redirection;
  bool keeps;  ///< true if the output arrives in the file %
};

void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }

constexpr std::array places{
    Place{"file", "", ">%", true}, Place{"pipe", "mkfifo pipe-%; cat pipe-% >% &", ">pipe-%", true},
    Place{"closed", "", ">&-", false}, Place{"full", "", ">/dev/full", false}};

std::string of_output(std::string text, const std::string& name) {
  for (std::size_t at = 0; (at = text.find('%', at)) != std::string::npos;)
    text.replace(at, 1, name);
  return text;
}

class OutputsOfReadRaw : public testing::TestWithParam<std::tuple<Place, Place>> {
 protected:
  /// Returns the exit code of read_raw for a column of numbers.csv.
  [[nodiscard]] int read(const std::string& column) const {
    const auto& [out, err] = GetParam();
    folder_.write("numbers.csv", "1.5\n-2\n0.25\n");
    folder_.write("out", "");
    folder_.write("err", "");
    folder_.write("script", "cd " + folder_.path().string() + '\n' + of_output(out.before, "out") +
                                '\n' + of_output(err.before, "err") + '\n' + PIAE_BIN +
                                "/read_raw --file numbers.csv --variable " + column + " 1" +
                                of_output(out.redirection, "out") + " 2" +
                                of_output(err.redirection, "err") +
                                "\ncode=$?\nwait\nexit $code\n");
    const int status = std::system(("bash " + (folder_ / "script").string()).c_str());
    return WEXITSTATUS(status);
  }
  [[nodiscard]] std::string printed() const { return bytes_of(folder_ / "err"); }

  Folder folder_;
};

TEST_P(OutputsOfReadRaw, HaveTheNumbersOrAReason) {
  const auto& [out, err] = GetParam();
  EXPECT_EQ(read("1"), out.keeps ? 0 : 1);
  if (out.keeps) {
    const std::string bytes = bytes_of(folder_ / "out");
    std::array<double, 3> numbers{};
    ASSERT_EQ(bytes.size(), sizeof numbers);
    std::memcpy(numbers.data(), bytes.data(), bytes.size());
    EXPECT_THAT(numbers, testing::ElementsAre(1.5, -2, 0.25));
    EXPECT_EQ(printed(), "");
  } else if (err.keeps) {
    EXPECT_THAT(printed(), HasSubstr("read_raw: standard output: "));
  }
}

TEST_P(OutputsOfReadRaw, ReportAFaultInTheFile) {
  const auto& [out, err] = GetParam();
  EXPECT_EQ(read("7"), 65);
  if (err.keeps) {
    EXPECT_THAT(printed(), HasSubstr("read_raw: numbers.csv, line 1: has no column 7"));
  }
}

/// libhdf5 1.10 crashes if the layout of a dataset has an older version than it was written with.
TEST(ReadRaw, ReportsACrashOfALibraryInALine) {
  const Folder folder;
  const std::vector<double> values(2000, 1.5);
  {
    const harmful::NewHdf5 file(folder / "a.h5");
    file.dataset("x", H5T_IEEE_F64LE, values.size(), H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file.id, "x", H5P_DEFAULT);
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(dataset);
  }
  const Arguments arguments{"--file", "a.h5", "--variable", "x"};
  EXPECT_EQ(run(folder.path(), "read_raw", arguments).status, 0);
  std::string bytes = bytes_of(folder / "a.h5");
  const std::size_t layout = bytes.find(std::string("\x08\0\x18\0\0\0\0\0\x03\x01", 10));
  ASSERT_NE(layout, std::string::npos);
  bytes[layout + 8] = 2;
  folder.write("a.h5", bytes);
  const Outcome outcome = run(folder.path(), "read_raw", arguments);
  EXPECT_EQ(outcome.status, 65);
  EXPECT_THAT(outcome.err, testing::StartsWith("read_raw: a.h5: "));
  EXPECT_EQ(outcome.out, "");
}

INSTANTIATE_TEST_SUITE_P(Places, OutputsOfReadRaw,
                         testing::Combine(testing::ValuesIn(places), testing::ValuesIn(places)));

}  // namespace
}  // namespace piae::stages
