#include "raw/lvm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::raw {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

/// Returns a file header (NI, "Specification for the LabVIEW Measurement File (.lvm)").
std::string lvm_header(const std::string& multi_headings, const std::string& x_columns,
                       const std::string& decimal_sign = ".") {
  return "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\n"
         "Decimal_Separator\t" +
         decimal_sign + "\nMulti_Headings\t" + multi_headings + "\nX_Columns\t" + x_columns +
         "\nTime_Pref\tAbsolute\nDate\t2024/02/24\nTime\t10:00:00.25\n***End_of_Header***\t\n\t\n";
}

/// Returns a segment header of two channels with three samples each.
std::string segment_header(const std::string& names, const std::string& samples = "3\t3",
                           const std::string& steps = "0.0001\t0.0002") {
  return "Notes\tnone\t\nChannels\t2\t\t\nSamples\t" + samples +
         "\t\nDate\t2024/02/24\t2024/02/24\t\nY_Unit_Label\tg\tN\t\nX_Dimension\tTime\tTime\t\n"
         "X0\t0.0\t0.0\t\nDelta_X\t" +
         steps + "\t\n***End_of_Header***\t\t\t\n" + names + "\n";
}

class Lvm : public testing::Test {
 protected:
  [[nodiscard]] std::vector<double> samples(const std::string& text,
                                            const std::string& channel) const {
    return read_here(folder_.write("a.lvm", text), channel);
  }
  void expect_refused(const std::string& text, const std::string& channel,
                      const std::string& why) const {
    EXPECT_ERROR(samples(text, channel), Exit::bad_input, "a.lvm" + why);
  }

  Folder folder_;
  const std::string one_ = lvm_header("No", "One") + segment_header("X_Value\tacc\tforce\tComment");
};

TEST_F(Lvm, IsRefusedWithCommasAsDecimalSignsAndBetweenFields) {
  const auto with_commas = [](const std::string& decimal_sign) {
    std::string text = lvm_header("No", "One", decimal_sign) +
                       segment_header("X_Value\tacc\tforce\tComment") +
                       "0\t1\t-7\n1\t-2\t8\n2\t3\t9\n";
    std::ranges::replace(text, '\t', ',');
    return text;
  };
  EXPECT_THAT(samples(with_commas("."), "force"), ElementsAre(-7, 8, 9));
  expect_refused(
      with_commas(","), "force",
      ", line 11: ends a header with commas as decimal signs and between the fields; write "
      "the file with tabs between the fields");
}

TEST_F(Lvm, MayHaveAByteOrderMark) {
  const std::string text = one_ + "0.0\t1.5\t-7\n0.1\t-2\t8\n0.2\t3\t9\n";
  std::string low_first = "\xFF\xFE";
  std::string high_first = "\xFE\xFF";
  for (const char c : text) {
    low_first += {c, '\0'};
    high_first += {'\0', c};
  }
  for (const std::string& marked : {"\xEF\xBB\xBF" + text, low_first, high_first}) {
    EXPECT_THAT(samples(marked, "force"), ElementsAre(-7, 8, 9));
  }
  expect_refused("\xEF\xBB\xBF{\"x\": 1}", "1", ": is JSON");
}

TEST_F(Lvm, HasChannelsByNameOrNumber) {
  const std::string text = one_ + "0.0\t1.5\t-7\tstart\n0.1\t-2\t8\n0.2\t3E-3\t9\t\n";
  EXPECT_THAT(samples(text, "acc"), ElementsAre(1.5, -2, 0.003));
  EXPECT_THAT(samples(text, "1"), ElementsAre(1.5, -2, 0.003));
  EXPECT_THAT(samples(text, "force"), ElementsAre(-7, 8, 9));
  EXPECT_THAT(samples(text, "2"), ElementsAre(-7, 8, 9));
  for (const char* wanted : {"3", "0", "X_Value", "Comment"}) {
    expect_refused(text, wanted,
                   std::string(", line 22: has no channel ") + wanted + "; it has acc, force");
  }
}

TEST_F(Lvm, HasTimesInOneColumnOrForEachChannelOrNone) {
  const std::string none = lvm_header("Yes", "No", ",") +
                           segment_header("X_Value\tacc\tforce\tComment") +
                           "\t1,5\t-7\n\t-2\t8,25\n\t3\t9\n";
  EXPECT_THAT(samples(none, "acc"), ElementsAre(1.5, -2, 3));
  EXPECT_THAT(samples(none, "2"), ElementsAre(-7, 8.25, 9));
  const std::string each =
      lvm_header("Yes", "Multi") +
      segment_header("X_Value\tacc\tX_Value\tforce\tComment", "3\t\t3", "0.0001\t\t0.0002") +
      "0.0\t1.5\t0.0\t-7\n0.1\t-2\t0.2\t8\n0.2\t3\t0.4\t9\n";
  EXPECT_THAT(samples(each, "1"), ElementsAre(1.5, -2, 3));
  EXPECT_THAT(samples(each, "force"), ElementsAre(-7, 8, 9));
  EXPECT_THAT(read_lvm(folder_ / "a.lvm", "2").sample_rate_hz.value_or(0), DoubleEq(5000));
}

TEST_F(Lvm, MayBeSeparatedByCommas) {
  std::string text = one_ + "0.0\t1.5\t-7\n0.1\t-2\t8\n0.2\t3\t9\n";
  std::ranges::replace(text, '\t', ',');
  text.replace(text.find("Separator,Tab"), 13, "Separator,Comma");
  EXPECT_THAT(samples(text, "acc"), ElementsAre(1.5, -2, 3));
}

TEST_F(Lvm, GivesItsSampleRate) {
  const auto file = folder_.write("a.lvm", one_ + "0\t1\t2\n0\t3\t4\n0\t5\t6\n");
  EXPECT_THAT(read_lvm(file, "acc").sample_rate_hz.value_or(0), DoubleEq(10000));
  EXPECT_THAT(read_lvm(file, "2").sample_rate_hz.value_or(0), DoubleEq(5000));
  EXPECT_ERROR(read_here(file, "acc", 12000), Exit::bad_input,
               "declares a sample rate of 10000 Hz, not 12000 Hz");
  std::string other = one_;
  other.replace(other.find("X_Dimension\tTime"), 16, "X_Dimension\tFrequency");
  expect_refused(other + "0\t1\t2\n0\t3\t4\n0\t5\t6\n", "1",
                 ": channel acc is not sampled over Time, but over Frequency");
}

TEST_F(Lvm, AcceptsEmptyFieldsOfSlowerChannels) {
  const std::string text = lvm_header("No", "One") +
                           segment_header("X_Value\tacc\tforce\tComment", "3\t1") +
                           "0\t1\t-1\n0\t2\t\n0\t3\n0\t4\t-2\n0\t5\t\n0\t6\t\t\n";
  EXPECT_THAT(samples(text, "acc"), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(samples(text, "force"), ElementsAre(-1, -2));
  expect_refused(text + "0\t\t-3\n", "acc", ", line 29: channel acc holds '', not a number");
  expect_refused(text + "0\t7\t\n", "force", ", line 29: channel force holds '', not a number");
  expect_refused(text + "0\t7\t-3\n0\t8\t-4\n", "force",
                 ", line 30: channel force holds '-4', where its header declares no value");
}

/// A row that lost a field has the later values one column too far left.
TEST_F(Lvm, IsRefusedIfARowLostAField) {
  const std::string rows = "0\t1\t-1\n0\t2\t-2\n";
  for (const char* channel : {"acc", "force"}) {
    expect_refused(one_ + rows + "0\t-3\n", channel,
                   ", line 25: channel force holds '', not a number");
    expect_refused(one_ + rows + "0\t-3\tnote\n", channel,
                   ", line 25: channel force holds 'note', not a number");
    expect_refused(one_ + rows + "0\n", channel, ", line 25: channel acc holds '', not a number");
  }
  const std::string each =
      lvm_header("No", "Multi") +
      segment_header("X_Value\tacc\tX_Value\tforce\tComment", "3\t\t3", "0.0001\t\t0.0002");
  expect_refused(each + "0\t1\t0\t-1\n0\t2\t0\t-2\n0\t0\t-3\n", "acc",
                 ", line 25: channel force holds '', not a number");
  // A slower channel has no values in the later rows of a packet.
  const std::string slow = lvm_header("No", "One") +
                           segment_header("X_Value\tacc\tforce\tComment", "2\t1") + "0\t1\t-1\n";
  EXPECT_THAT(samples(slow + "0\t2\n", "acc"), ElementsAre(1, 2));
  expect_refused(slow + "0\t\t2\n", "acc", ", line 24: channel acc holds '', not a number");
  expect_refused(slow + "0\t2\t-2\n", "acc",
                 ", line 24: channel force holds '-2', where its header declares no value");
}

TEST_F(Lvm, MayHaveASpecialBlockInItsHeader) {
  const std::string special = "***Start_Special***\t\nanything\t1\n***End_Special***\t\n";
  std::string text = one_ + "0\t1\t2\n0\t3\t4\n0\t5\t6\n";
  text.insert(text.find("Notes"), special);
  EXPECT_THAT(samples(text, "acc"), ElementsAre(1, 3, 5));
}

TEST_F(Lvm, IsRefusedIfTruncatedOrDamaged) {
  const std::string rows = "0\t1.5\t-7\n0\t-2\t8\n";
  expect_refused(one_ + rows, "1", ": truncated: it has 2 rows, but its header declares 3");
  for (std::size_t size = 20; size < one_.size(); size += 9) {
    SCOPED_TRACE(size);
    expect_refused(one_.substr(0, size), "1", "");
  }
  expect_refused(one_ + rows + "0\tx\t9\n", "1", ", line 25: channel acc holds 'x', not a number");
  expect_refused(
      one_ + rows + "0\t1,5\t9\n", "1",
      ", line 25: channel acc holds '1,5', whose decimal sign is not the one in the header");
  expect_refused(one_ + rows + "0\t1\t9\t\t2\n", "1", ", line 25: has 5 fields");
  const std::string yes = lvm_header("Yes", "One") + segment_header("X_Value\tacc\tforce\tComment");
  expect_refused(yes + rows + rows, "1",
                 ", line 26: is one row more than the 3 that its header declares");
}

TEST_F(Lvm, IsRefusedAtTheLineOfASecondSegment) {
  const std::string rows = "0\t1\t2\n0\t3\t4\n0\t5\t6\n";
  expect_refused(one_ + rows + "\t\n" + segment_header("X_Value\tacc\tforce\tComment") + rows,
                 "acc",
                 ", line 26: ends the first segment, and another one with its own header follows");
}

TEST_F(Lvm, IsRefusedIfCutWithinItsLastNumber) {
  std::string text =
      lvm_header("No", "One") + segment_header("X_Value\tacc\tforce\tComment", "200\t200");
  for (int i = 0; i < 200; ++i) text += "0.1\t1.250000\t-2.500000\n";
  EXPECT_EQ(samples(text, "force").size(), 200U);
  EXPECT_EQ(samples(text.substr(0, text.size() - 1), "force").size(), 200U);
  EXPECT_EQ(samples(text.substr(0, text.size() - 3), "acc").size(), 200U);
  expect_refused(text.substr(0, text.size() - 3), "force",
                 ", line 222: ends the file with '-2.5000', with fewer digits than all others");
}

TEST_F(Lvm, IsReadByNumberIfNotInUtf8) {
  std::string text = one_ + "0\t1\t2\n0\t3\t4\n0\t5\t6\n";
  text.replace(text.find("\tacc"), 4, "\tSchwingst\xe4rke");
  EXPECT_THAT(samples(text, "1"), ElementsAre(1, 3, 5));
  EXPECT_THAT(samples(text, "force"), ElementsAre(2, 4, 6));
  expect_refused(
      text, "Schwingstärke",
      ", line 22: has no channel Schwingstärke; the file is not in UTF-8, so name the channel "
      "by its number, 1 to 2");
}

TEST_F(Lvm, IsReadAsATableWithoutHeaders) {
  EXPECT_THAT(samples("0.0\t1.5\n0.1\t-2\n", "2"), ElementsAre(1.5, -2));
}

}  // namespace
}  // namespace piae::raw
