#include "raw/uff.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::raw {
namespace {

namespace fs = std::filesystem;
using testing::DoubleNear;
using testing::ElementsAre;

/// Header fields of a data set 58, record by record (SDRC, "Universal Dataset Number 58").
struct UffHeader {
  std::string name = "Bearing 1";
  int function = 1;  ///< time response
  int ordinate = 2;  ///< single precision
  int count = 3;
  int even = 1;
  int abscissa = 17;  ///< time
};

std::string in_columns(int number, std::size_t width) {
  const std::string digits = std::to_string(number);
  return std::string(width - digits.size(), ' ') + digits;
}

/// Returns the eleven lines after the type.
std::string header_lines(const UffHeader& about, const std::string& end) {
  const std::string units = "    0    0    0 NONE                 NONE                ";
  return about.name + std::string(80 - about.name.size(), ' ') + end + "NONE" + end +
         "30-Apr-20 19:12:52" + end + "NONE" + end + "NONE" + end + in_columns(about.function, 5) +
         "         0    0         0 NONE               0   0 NONE               0   0" + end +
         in_columns(about.ordinate, 10) + in_columns(about.count, 10) + in_columns(about.even, 10) +
         "  0.00000E+00  8.33333E-05  0.00000E+00" + end + in_columns(about.abscissa, 10) + units +
         end + "        12" + units + end + "         0" + units + end + "         0" + units + end;
}

std::string text_set(const UffHeader& about, const std::string& values,
                     const std::string& end = "\n") {
  return "    -1" + end + "    58" + end + header_lines(about, end) + values + "    -1" + end;
}

const std::string three_singles = "  1.50000E+00 -2.00000E+00  3.00000E-09\n";

std::string binary_set(const UffHeader& about, const std::string& bytes, bool is_big,
                       const std::string& before_mark = "") {
  return "    -1\n    58b" + in_columns(is_big ? 2 : 1, 6) + in_columns(2, 6) + in_columns(11, 12) +
         in_columns(static_cast<int>(bytes.size()), 12) + "     0     0           0           0\n" +
         header_lines(about, "\n") + bytes + before_mark + "    -1\n";
}

template <class T>
std::string bytes_of_numbers(const std::vector<T>& numbers, bool is_big) {
  std::string all;
  for (const T number : numbers) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &number, sizeof(T));
    if (is_big == (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
    all += bytes;
  }
  return all;
}

class Uff : public testing::Test {
 protected:
  [[nodiscard]] std::vector<double> samples(const std::string& bytes,
                                            const std::string& variable = "1") const {
    return read_here(folder_.write("a.uff", bytes), variable);
  }
  void expect_refused(const std::string& bytes, const std::string& why,
                      const std::string& variable = "1") const {
    EXPECT_ERROR(samples(bytes, variable), Exit::bad_input, "a.uff: " + why);
  }

  Folder folder_;
};

TEST_F(Uff, MayHaveAByteOrderMark) {
  const std::string text = text_set({}, three_singles);
  EXPECT_EQ(samples("\xEF\xBB\xBF" + text), samples(text));
}

TEST_F(Uff, HasTextInFieldsOfAFixedWidth) {
  EXPECT_THAT(samples(text_set({}, three_singles)), ElementsAre(1.5, -2, 3e-9));
  std::string wide;  // fields of 20 columns
  for (const char* field : {"  1.500000000000E+00", " -2.000000000000D+00", "  3.00000000000E-009"})
    wide += field;
  EXPECT_THAT(samples(text_set({.ordinate = 4}, wide + "\n")), ElementsAre(1.5, -2, 3e-9));
  // Fields of another width, without blanks between them, on several lines, with blanks at their
  // ends and CRLF.
  const std::string full = "-1.50000E+000-2.00000E+000 3.00000E-009\r\n  4.00000E+00          \r\n";
  EXPECT_THAT(samples(text_set({}, "   1.500E+00  -2.000E+00   3.000E-09\n")),
              ElementsAre(1.5, -2, 3e-9));
  EXPECT_THAT(samples(text_set({.count = 4}, full, "\r\n")), ElementsAre(-1.5, -2, 3e-9, 4));
}

TEST_F(Uff, HasBytesInEitherOrder) {
  for (const bool is_big : {false, true}) {
    const std::string singles = bytes_of_numbers<float>({1.5F, -2, 0.25F}, is_big);
    const std::string doubles = bytes_of_numbers<double>({1.5, -2, 3e-9}, is_big);
    EXPECT_THAT(samples(binary_set({}, singles, is_big)), ElementsAre(1.5, -2, 0.25));
    EXPECT_THAT(samples(binary_set({.ordinate = 4}, doubles, is_big, "\n")),
                ElementsAre(1.5, -2, 3e-9));
  }
}

TEST_F(Uff, HasSeveralDataSetsByNumberOrName) {
  const std::string units = "    -1\n   164\n         1  SI: Meter (newton)         2\n    -1\n";
  // Binary data may hold bytes of a mark or a line end.
  const std::string odd = std::string("\n    -1\n\x3f\x3f\x3f\x3f", 12);
  const std::string file =
      units + binary_set({.name = "Bearing 1"}, odd, true) +
      text_set({.name = "Bearing 2"}, "  7.00000E+00  8.00000E+00  9.00000E+00\n") + units +
      text_set({.name = "NONE"}, three_singles) + text_set({.name = "NONE"}, three_singles);
  EXPECT_EQ(samples(file, "1").size(), 3U);
  EXPECT_THAT(samples(file, "2"), ElementsAre(7, 8, 9));
  EXPECT_THAT(samples(file, "Bearing 2"), ElementsAre(7, 8, 9));
  expect_refused(file, "has several data sets NONE; name one by its number, 1 to 4", "NONE");
  expect_refused(file, "has no data set 5; it has 1 (Bearing 1), 2 (Bearing 2), 3 (NONE), 4 (NONE)",
                 "5");
  expect_refused(units, "has no time record (data set 58); it has data sets 164");
}

TEST_F(Uff, GivesItsSampleRate) {
  const fs::path file = folder_.write("a.uff", text_set({}, three_singles));
  EXPECT_THAT(read_uff(file, "1").sample_rate_hz.value_or(0), DoubleNear(12000, 0.1));
  EXPECT_EQ(read_here(file, "1", 12000).size(), 3U);
  EXPECT_ERROR(read_here(file, "1", 25600), Exit::bad_input, "declares a sample rate of");
}

TEST_F(Uff, IsRefusedWithItsTypeIfNotATimeRecord) {
  expect_refused(text_set({.function = 4, .ordinate = 5, .abscissa = 18}, three_singles),
                 "data set 1 is a frequency response function, not a time record");
  expect_refused(text_set({.function = 9}, three_singles),
                 "data set 1 is a power spectral density");
  expect_refused(text_set({.function = 25}, three_singles), "data set 1 is of function type 25");
  expect_refused(text_set({.abscissa = 18}, three_singles), "data set 1 is not a function of time");
  expect_refused(text_set({.ordinate = 5}, three_singles), "data set 1 holds complex numbers");
  expect_refused(text_set({.even = 0}, three_singles), "data set 1 has uneven spacing");
}

TEST_F(Uff, IsRefusedIfTruncatedOrDamaged) {
  const std::string whole = text_set({}, three_singles);
  for (std::size_t size = 7; size < whole.size() - 1; size += 5) {
    SCOPED_TRACE(size);
    expect_refused(whole.substr(0, size), "");
  }
  const std::string bytes = binary_set({}, bytes_of_numbers<float>({1, 2, 3}, false), false);
  for (std::size_t size = 7; size < bytes.size() - 1; size += 5) {
    SCOPED_TRACE(size);
    expect_refused(bytes.substr(0, size), "");
  }
  expect_refused(text_set({.count = 4}, three_singles),
                 "data set 1 is truncated or damaged: 3 values, 4 expected");
  expect_refused(
      text_set({}, "  1.50000E+00 -2.0x000E+00  3.00000E-09\n"),
      "data set 1 has a line 14 that does not hold numbers 13 columns wide: '1.50000E+00 ");
  expect_refused(binary_set({.count = 4}, bytes_of_numbers<float>({1, 2, 3}, false), false),
                 "data set 1 is truncated or damaged: 12 bytes of values, 4 values expected");
  expect_refused(binary_set({}, bytes_of_numbers<float>({1, 2, 3}, false), false, "xx"),
                 "truncated or damaged: its values do not end where it declares");
  std::string vax = bytes;
  vax.replace(vax.find("58b") + 3, 12, "     1     1");
  expect_refused(
      vax, "data set 1 has numbers of a DEC or IBM computer, which are not supported; export");
}

TEST_F(Uff, IsDistinguishedFromColumnsOfWholeNumbers) {
  EXPECT_THAT(read_here(folder_.write("a.txt", "    -1\n     3\n    58\n"), "1"),
              ElementsAre(-1, 3, 58));
  EXPECT_ERROR(read_here(folder_.write("a.uff", "1\n2\n"), "1"), Exit::bad_input,
               "a.uff: truncated, damaged or not a '.uff' file");
}

}  // namespace
}  // namespace piae::raw
