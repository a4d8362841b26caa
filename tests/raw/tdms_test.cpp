#include "raw/tdms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/tdms_writer.hpp"

namespace piae::raw {
namespace {

namespace fs = std::filesystem;
using testing::DoubleEq;
using testing::ElementsAre;
using Doubles = std::vector<double>;
using Shorts = std::vector<std::int16_t>;

/// Returns a file with channels rig/acc (double) and rig/tacho (16 bits) of three values each.
std::string two_channels(const tdms::Writer& write, bool is_interleaved) {
  const std::vector<std::string> objects{
      write.object("/", write.no_values(), {write.property("name", std::string("run 7"))}),
      write.object("/'rig'", write.no_values()),
      write.object("/'rig'/'acc'", write.index(tdms::dbl, 3),
                   {write.property("unit_string", std::string("g")),
                    write.property("wf_increment", 1 / 12000.0)}),
      write.object("/'rig'/'tacho'", write.index(tdms::int16, 3))};
  if (!is_interleaved) {
    return write.segment(tdms::new_values, objects,
                         write.numbers(Doubles{1.5, -2, 3e-9}) + write.numbers(Shorts{-7, 8, 9}));
  }
  std::string rows;
  for (const auto& [acc, tacho] : {std::pair{1.5, -7}, std::pair{-2.0, 8}, std::pair{3e-9, 9}}) {
    rows += write.number(acc) + write.number(static_cast<std::int16_t>(tacho));
  }
  return write.segment(tdms::new_values | tdms::interleaved, objects, rows);
}

class Tdms : public testing::Test {
 protected:
  [[nodiscard]] fs::path written(const std::string& bytes) const {
    return folder_.write("a.tdms", bytes);
  }
  [[nodiscard]] std::vector<double> samples(const std::string& bytes,
                                            const std::string& channel) const {
    return read_here(written(bytes), channel);
  }
  void expect_refused(const std::string& bytes, const std::string& channel,
                      const std::string& why) const {
    EXPECT_ERROR(samples(bytes, channel), Exit::bad_input, "a.tdms: " + why);
  }

  Folder folder_;
  tdms::Writer write_;
};

TEST_F(Tdms, HasChannelsByPathOrNumberInEitherByteOrderAndLayout) {
  for (const bool is_big : {false, true}) {
    for (const bool is_interleaved : {false, true}) {
      SCOPED_TRACE(is_big ? "big-endian" : "little-endian");
      const std::string bytes = two_channels(tdms::Writer(is_big), is_interleaved);
      EXPECT_THAT(samples(bytes, "rig/acc"), ElementsAre(1.5, -2, 3e-9));
      EXPECT_THAT(samples(bytes, "1"), ElementsAre(1.5, -2, 3e-9));
      EXPECT_THAT(samples(bytes, "rig/tacho"), ElementsAre(-7, 8, 9));
      EXPECT_THAT(samples(bytes, "2"), ElementsAre(-7, 8, 9));
    }
  }
}

TEST_F(Tdms, ListsChannelsIfTheRequestedOneIsMissing) {
  const std::string bytes = two_channels(write_, false);
  for (const char* wanted : {"3", "0", "acc", "rig", ""}) {
    expect_refused(bytes, wanted,
                   std::string("has no channel ") + wanted + "; it has rig/acc, rig/tacho");
  }
}

TEST_F(Tdms, GivesItsSampleRate) {
  const fs::path file = written(two_channels(write_, false));
  EXPECT_THAT(read_tdms(file, "rig/acc").sample_rate_hz.value_or(0), DoubleEq(12000));
  EXPECT_EQ(read_tdms(file, "rig/tacho").sample_rate_hz, std::nullopt);
  EXPECT_EQ(read_here(file, "rig/acc", 12000).size(), 3U);
  EXPECT_ERROR(read_here(file, "rig/acc", 25600), Exit::bad_input,
               "declares a sample rate of 12000 Hz, not 25600 Hz");
}

TEST_F(Tdms, HasNumbersOfAnyType) {
  const auto read_as = [&](std::uint32_t type, const auto& values) {
    return samples(write_.segment(tdms::new_values,
                                  {write_.object("/'a'/'b'", write_.index(type, values.size()))},
                                  write_.numbers(values)),
                   "1");
  };
  EXPECT_THAT(read_as(tdms::int8, std::vector<std::int8_t>{-128, 127}), ElementsAre(-128, 127));
  EXPECT_THAT(read_as(tdms::uint8, std::vector<std::uint8_t>{0, 255}), ElementsAre(0, 255));
  EXPECT_THAT(read_as(tdms::int16, Shorts{-32768, 7}), ElementsAre(-32768, 7));
  EXPECT_THAT(read_as(tdms::uint16, std::vector<std::uint16_t>{7, 65535}), ElementsAre(7, 65535));
  EXPECT_THAT(read_as(tdms::int32, std::vector<std::int32_t>{-8388608, 8388607}),
              ElementsAre(-8388608, 8388607));
  EXPECT_THAT(read_as(tdms::uint32, std::vector<std::uint32_t>{1, 4294967295}),
              ElementsAre(1, 4294967295));
  EXPECT_THAT(read_as(tdms::int64, std::vector<std::int64_t>{-5, 1LL << 40}),
              ElementsAre(-5, 1099511627776));
  EXPECT_THAT(read_as(tdms::uint64, std::vector<std::uint64_t>{5, 1ULL << 40}),
              ElementsAre(5, 1099511627776));
  EXPECT_THAT(read_as(tdms::single, std::vector<float>{0.5F, -1}), ElementsAre(0.5, -1));
}

TEST_F(Tdms, MayHaveSegmentsWithPartialMetadata) {
  const auto shorts = [&](const Shorts& values) { return write_.numbers(values); };
  const std::string a = "/'g'/'a'";
  const std::string b = "/'g'/'b'";
  std::string bytes = write_.segment(tdms::new_values,
                                     {write_.object(a, write_.index(tdms::int16, 2)),
                                      write_.object(b, write_.index(tdms::int16, 1))},
                                     shorts({1, 2, -1, 3, 4, -2}));  // two chunks
  bytes += write_.segment(tdms::raw_data, {}, shorts({5, 6, -3}));   // unchanged list and sizes
  bytes += write_.segment(tdms::raw_data | tdms::metadata,           // b has two values from now on
                          {write_.object(b, write_.index(tdms::int16, 2))}, shorts({7, 8, -4, -5}));
  bytes += write_.segment(tdms::raw_data | tdms::metadata,  // a has none
                          {write_.object(a, write_.no_values())}, shorts({-6, -7}));
  bytes +=
      write_.segment(tdms::new_values, {write_.object(a, write_.as_before())}, shorts({9, 10}));
  bytes += write_.segment(
      tdms::metadata,  // no values at all
      {write_.object(a, write_.as_before(), {write_.property("wf_increment", 0.001)})}, "");
  EXPECT_THAT(samples(bytes, "g/a"), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
  EXPECT_THAT(samples(bytes, "g/b"), ElementsAre(-1, -2, -3, -4, -5, -6, -7));
  EXPECT_EQ(read_tdms(written(bytes), "g/a").sample_rate_hz, 1000);
}

TEST_F(Tdms, SkipsOtherDataBetweenNumbers) {
  const std::string labels = write_.number(std::uint32_t{1}) + write_.number(std::uint32_t{4}) +
                             "abcd";  // ends of two texts, then their letters
  const std::string bytes =
      write_.segment(tdms::new_values,
                     {write_.object("/'it''s'/'label'", write_.index_of_text(2, labels.size())),
                      write_.object("/'it''s'/'when'", write_.index(tdms::time_stamp, 1)),
                      write_.object("/'it''s'/'a/b'", write_.index(tdms::dbl, 2))},
                     labels + std::string(16, '\x7f') + write_.numbers(Doubles{4, 5}));
  EXPECT_THAT(samples(bytes, "it's/a/b"), ElementsAre(4, 5));
  const std::string remedy =
      "', which is not supported; name a channel of real numbers, or save this one as double";
  expect_refused(bytes, "1", "channel it's/label has values of the type 'text" + remedy);
  expect_refused(bytes, "2", "channel it's/when has values of the type 'time stamp" + remedy);
}

/// The types of NI's enumeration tdsDataType that do not hold real numbers, with their sizes. A
/// channel of numbers follows in each chunk, and in each row if interleaved.
TEST_F(Tdms, SkipsAnUnsupportedTypeOfKnownSize) {
  struct Type {
    std::uint32_t id;
    std::size_t bytes;
    std::string name;
  };
  for (const Type& type :
       {Type{0x21, 1, "boolean"}, Type{tdms::time_stamp, 16, "time stamp"},
        Type{0x08000C, 8, "complex single"}, Type{0x10000D, 16, "complex double"}}) {
    SCOPED_TRACE(type.name);
    const std::vector<std::string> objects{write_.object("/'g'/'a'", write_.index(type.id, 2)),
                                           write_.object("/'g'/'b'", write_.index(tdms::dbl, 2))};
    const std::string other(type.bytes, '\1');
    const auto number = [&](double value) { return write_.number(value); };
    const std::string chunk = other + other + number(4) + number(5);
    const std::string chunks = write_.segment(tdms::new_values, objects, chunk + chunk);
    EXPECT_THAT(samples(chunks, "g/b"), ElementsAre(4, 5, 4, 5));
    expect_refused(
        chunks, "g/a",
        "channel g/a has values of the type '" + type.name + "', which is not supported");
    const std::string rows = write_.segment(tdms::new_values | tdms::interleaved, objects,
                                            other + number(4) + other + number(5));
    EXPECT_THAT(samples(rows, "g/b"), ElementsAre(4, 5));
  }
}

TEST_F(Tdms, IsRefusedWithATypeOfUnknownSize) {
  for (const auto& [id, name] :
       {std::pair{0x0BU, "extended float"}, std::pair{0x1BU, "extended float with a unit"},
        std::pair{0x4FU, "fixed point"}, std::pair{0xFFFFFFFFU, "NI-DAQmx raw data"}}) {
    const std::string why = std::string(" has the type '") + name +
                            "', which is not supported, and whose size is unknown, so the rest of "
                            "the file cannot be read; save the ";
    expect_refused(write_.segment(tdms::new_values,
                                  {write_.object("/'g'/'a'", write_.index(id, 1)),
                                   write_.object("/'g'/'b'", write_.index(tdms::dbl, 1))},
                                  std::string(24, '\1')),
                   "g/b", "channel g/a" + why + "channel as double, or the file without it");
    const std::string property = write_.words("limit") + write_.number(id) + std::string(16, '\1');
    expect_refused(
        write_.segment(tdms::new_values,
                       {write_.object("/'g'/'a'", write_.index(tdms::dbl, 1), {property})},
                       "12345678"),
        "1", "a property" + why + "file without it");
  }
}

TEST_F(Tdms, AppliesItsScales) {
  const auto scaled = [&](const std::vector<std::string>& properties) {
    return write_.segment(tdms::new_values,
                          {write_.object("/'g'/'a'", write_.index(tdms::int16, 3), properties)},
                          write_.numbers(Shorts{-2, 0, 4}));
  };
  const auto words = [&](const std::string& name, const std::string& value) {
    return write_.property(name, value);
  };
  const auto count = [&](const std::string& name, std::uint32_t value) {
    return write_.property(name, value);
  };
  std::vector<std::string> linear{count("NI_Number_Of_Scales", 1),
                                  words("NI_Scaling_Status", "unscaled"),
                                  words("NI_Scale[0]_Scale_Type", "Linear"),
                                  write_.property("NI_Scale[0]_Linear_Slope", 0.5),
                                  write_.property("NI_Scale[0]_Linear_Y_Intercept", 10.0),
                                  count("NI_Scale[0]_Linear_Input_Source", 0xFFFFFFFF)};
  EXPECT_THAT(samples(scaled(linear), "1"), ElementsAre(9, 10, 12));
  std::vector<std::string> both = linear;  // 1 + 2 y + y^2 with y = 10 + x / 2
  both[0] = count("NI_Number_Of_Scales", 2);
  both.push_back(words("NI_Scale[1]_Scale_Type", "Polynomial"));
  both.push_back(count("NI_Scale[1]_Polynomial_Coefficients_Size", 3));
  for (const char* power : {"0", "1", "2"}) {
    both.push_back(
        write_.property(std::string("NI_Scale[1]_Polynomial_Coefficients[") + power + "]",
                        *power == '1' ? 2.0 : 1.0));
  }
  both.push_back(count("NI_Scale[1]_Polynomial_Input_Source", 0));
  EXPECT_THAT(samples(scaled(both), "1"), ElementsAre(100, 121, 169));
  linear[1] = words("NI_Scaling_Status", "scaled");
  EXPECT_THAT(samples(scaled(linear), "1"), ElementsAre(-2, 0, 4));
  expect_refused(scaled({words("NI_Scale[0]_Scale_Type", "Thermocouple")}), "1",
                 "channel g/a has a scale of the type 'Thermocouple', which is not supported");
  expect_refused(scaled({words("NI_Scale[0]_Scale_Type", "Linear")}), "1",
                 "channel g/a is damaged: its scale has no NI_Scale[0]_Linear_Y_Intercept");
  both.back() = count("NI_Scale[1]_Polynomial_Input_Source", 1);
  expect_refused(scaled(both), "1", "channel g/a is damaged: the source of a scale does not exist");
}

TEST_F(Tdms, IsReadToTheLastWholeChunkIfTheWriterCrashed) {
  const auto numbers = [&](const Doubles& values) { return write_.numbers(values); };
  const std::vector<std::string> objects{write_.object("/'g'/'a'", write_.index(tdms::dbl, 2)),
                                         write_.object("/'g'/'b'", write_.index(tdms::dbl, 1))};
  const std::string whole = write_.segment(tdms::new_values, objects, numbers({1, 2, -1}));
  const std::string last =
      write_.segment(tdms::new_values, objects, numbers({3, 4, -2, 5, 6, -3}), tdms::crashed);
  EXPECT_THAT(samples(whole + last, "g/a"), ElementsAre(1, 2, 3, 4, 5, 6));
  const std::string cut = (whole + last).substr(0, whole.size() + last.size() - 5);
  EXPECT_THAT(samples(cut, "g/a"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(samples(cut, "g/b"), ElementsAre(-1, -2));
  // A segment cut in its metadata contributes no values.
  EXPECT_THAT(samples(whole + last.substr(0, 60), "g/a"), ElementsAre(1, 2));
  // A single channel keeps each whole sample.
  const std::string alone =
      write_.segment(tdms::new_values, {write_.object("/'g'/'a'", write_.index(tdms::dbl, 1000))},
                     numbers({1, 2, 3}), tdms::crashed);
  EXPECT_THAT(samples(alone.substr(0, alone.size() - 1), "g/a"), ElementsAre(1, 2));
  const std::string rows =
      write_.segment(tdms::new_values | tdms::interleaved,
                     {write_.object("/'g'/'a'", write_.index(tdms::dbl, 1000)),
                      write_.object("/'g'/'b'", write_.index(tdms::dbl, 1000))},
                     numbers({1, -1, 2, -2, 3}), tdms::crashed);
  EXPECT_THAT(samples(rows, "g/b"), ElementsAre(-1, -2));
}

TEST_F(Tdms, IsRefusedIfShorterThanDeclared) {
  const std::string one = two_channels(write_, false);
  const std::string bytes = one + one;
  for (std::size_t size = 1; size < bytes.size(); size += 3) {
    if (size == one.size() || size < 4) continue;
    SCOPED_TRACE(size);
    expect_refused(bytes.substr(0, size), "rig/acc", "truncated or damaged: its segment at byte ");
  }
  expect_refused(bytes.substr(0, bytes.size() - 1), "1",
                 "truncated or damaged: its segment at byte " + std::to_string(one.size()) +
                     " declares " + std::to_string(one.size() - 28) + " bytes, but " +
                     std::to_string(one.size() - 29) + " are there");
  const std::string second = std::to_string(one.size());
  for (const std::string& cut : {one + "x", one + one.substr(0, 27)}) {
    expect_refused(cut, "1",
                   "truncated or damaged: its segment at byte " + second +
                       " ends within its first 28 bytes; if the writer crashed, "
                       "`truncate -s " +
                       second + " FILE` keeps the complete part");
  }
}

TEST_F(Tdms, IsRefusedWithImpossibleMetadata) {
  const auto with = [&](const std::string& object, const std::string& raw = "12345678") {
    return write_.segment(tdms::new_values, {object}, raw);
  };
  const std::string path = "/'g'/'a'";
  const std::uint64_t huge = 1ULL << 62U;
  expect_refused(with(write_.object(path, write_.as_before())), "1",
                 "damaged: an object refers to earlier values");
  expect_refused(with(write_.object(path, write_.index(77, 1))), "1", "damaged: an object has");
  expect_refused(with(write_.object(path, write_.index(tdms::nothing, 1))), "1",
                 "damaged: an object has values of an impossible size");
  expect_refused(with(write_.object("g/a", write_.index(tdms::dbl, 1))), "1",
                 "damaged: an object has a path");
  expect_refused(with(write_.object(path, write_.index(tdms::dbl, 1)), "1234567"), "1",
                 "truncated or damaged: its segment at byte 0 has 7 bytes of values");
  expect_refused(with(write_.words(path)), "1", "damaged: its metadata end too early");
  expect_refused(with(write_.object(path, write_.no_values())), "1",
                 "truncated or damaged: its segment at byte 0 has 8 bytes of values");
  const std::string two = write_.segment(tdms::new_values,
                                         {write_.object(path, write_.index(tdms::dbl, huge)),
                                          write_.object("/'g'/'b'", write_.index(tdms::dbl, huge))},
                                         "12345678");
  expect_refused(two, "1", "truncated or damaged: its segment at byte 0 has 8 bytes of values");
  expect_refused(
      write_.segment(tdms::metadata, {write_.object(path, write_.index(tdms::dbl, 1))}, "12345678"),
      "1", "truncated or damaged: its segment at byte 0 has more bytes");
}

/// Flips bits of a segment's layout, which no checksum covers. A single channel and interleaved
/// channels are read value by value, so the values alone would fit another layout, too.
TEST_F(Tdms, IsRefusedIfItsLayoutContradictsItsLength) {
  const Shorts values{1, 2, 3, 4, 5, 6, 7, 8};
  const std::string path = "/'g'/'a'";
  const auto single = [&](std::uint32_t type, std::uint64_t count) {
    return write_.segment(tdms::new_values, {write_.object(path, write_.index(type, count))},
                          write_.numbers(values));
  };
  EXPECT_EQ(samples(single(tdms::int16, 8), "1").size(), 8U);
  EXPECT_EQ(samples(single(tdms::int16, 4), "1").size(), 8U);  // two chunks
  const std::string why =
      "truncated or damaged: its segment at byte 0 has 16 bytes of values, not ";
  for (const std::uint32_t type : {tdms::int32, tdms::dbl, tdms::int64}) {
    expect_refused(single(type, 8), "1", why);
  }
  for (const std::uint64_t count : {9, 12, 16}) {
    expect_refused(single(tdms::int16, count), "1", why);
  }
  const auto rows = [&](std::uint32_t type, std::uint64_t count) {
    return write_.segment(tdms::new_values | tdms::interleaved,
                          {write_.object(path, write_.index(type, count)),
                           write_.object("/'g'/'b'", write_.index(type, count))},
                          write_.numbers(values));
  };
  EXPECT_THAT(samples(rows(tdms::int16, 4), "2"), ElementsAre(2, 4, 6, 8));
  expect_refused(rows(tdms::int32, 4), "2", why);
  expect_refused(rows(tdms::int16, 5), "2", why);
}

/// LabVIEW's own files may end a segment within a chunk (npTDMS, issues 40 and 109).
TEST_F(Tdms, MayEndASegmentWithinAChunkOfRows) {
  const std::string path = "/'g'/'a'";
  const auto index = [&](std::uint64_t count) { return write_.index(tdms::int16, count); };
  const auto single = [&](std::uint64_t count, const std::string& values) {
    return write_.segment(tdms::new_values, {write_.object(path, index(count))}, values);
  };
  const std::string values = write_.numbers(Shorts{1, 2, 3, 4, 5});
  EXPECT_THAT(samples(single(2, values), "1"), ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(samples(single(4, values) + single(1, values), "1"),
              ElementsAre(1, 2, 3, 4, 5, 1, 2, 3, 4, 5));
  const std::string why = "truncated or damaged: its segment at byte 0 has ";
  expect_refused(single(6, values), "1", why + "10 bytes of values, not ");
  expect_refused(single(2, values + "x"), "1", why + "11 bytes of values, not ");
  const auto rows = [&](std::uint32_t layout, const std::string& raw) {
    return write_.segment(tdms::new_values | layout,
                          {write_.object(path, index(2)), write_.object("/'g'/'b'", index(2))},
                          raw);
  };
  const std::string pairs = write_.numbers(Shorts{1, -1, 2, -2, 3, -3});
  EXPECT_THAT(samples(rows(tdms::interleaved, pairs), "1"), ElementsAre(1, 2, 3));
  EXPECT_THAT(samples(rows(tdms::interleaved, pairs), "2"), ElementsAre(-1, -2, -3));
  expect_refused(rows(tdms::interleaved, pairs + "12"), "1", why + "14 bytes of values, not ");
  // Channels one after the other have no rows.
  expect_refused(rows(0, pairs), "1", why + "12 bytes of values, not ");
}

/// Replaces a number of 4 bytes within a file.
std::string with_number(std::string bytes, std::size_t at, const std::string& number) {
  return bytes.replace(at, number.size(), number);
}

TEST_F(Tdms, IsRefusedIfItsMetadataDoNotEndAtItsValues) {
  const std::string path = "/'g'/'a'";
  const std::vector<std::string> slope{write_.property("wf_increment", 0.001),
                                       write_.property("NI_Scale[0]_Scale_Type", "Linear"),
                                       write_.property("NI_Scale[0]_Linear_Slope", 0.5),
                                       write_.property("NI_Scale[0]_Linear_Y_Intercept", 0.0)};
  const std::string bytes =
      write_.segment(tdms::new_values, {write_.object(path, write_.index(tdms::int8, 8), slope)},
                     "\1\2\3\4\5\6\7\x8");
  EXPECT_THAT(samples(bytes, "1"), ElementsAre(0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4));
  const std::string why = "damaged: its metadata do not end where its values begin";
  constexpr std::size_t raw_offset = 20;
  constexpr std::size_t objects = 28;
  const std::size_t properties = objects + 4 + 4 + path.size() + write_.index(tdms::int8, 8).size();
  for (const std::uint32_t fewer : {0, 1, 3}) {
    expect_refused(with_number(bytes, properties, write_.number(fewer)), "1", why);
  }
  expect_refused(with_number(bytes, objects, write_.number(std::uint32_t{0})), "1", why);
  // Metadata that the table of contents does not announce.
  const std::string more = write_.segment(
      tdms::raw_data, {write_.object(path, write_.as_before(), slope)}, "\1\2\3\4\5\6\7\x8");
  expect_refused(bytes + more, "1", why);
  // Another start of the values: within the metadata, or within the values.
  const auto about = static_cast<std::uint32_t>(bytes.size() - objects - 8);
  for (const int shift : {-8, -1}) {
    expect_refused(with_number(bytes, raw_offset, write_.number(about + shift)), "1",
                   "damaged: its metadata end too early");
  }
  for (const int shift : {1, 4, 7}) {
    expect_refused(with_number(bytes, raw_offset, write_.number(about + shift)), "1", why);
  }
  // Zeros may fill the space before the values.
  std::string padded = bytes;
  padded.insert(objects + about, 8, '\0');
  padded = with_number(padded, raw_offset, write_.number(about + 8));
  padded = with_number(padded, 12, write_.number(about + 16));
  EXPECT_EQ(samples(padded, "1").size(), 8U);
}

TEST_F(Tdms, IsRefusedIfItsRateOrScaleChangesAmongItsValues) {
  const std::string path = "/'g'/'a'";
  const auto segment = [&](const std::string& name, double value) {
    return write_.segment(
        tdms::new_values,
        {write_.object(path, write_.index(tdms::dbl, 2), {write_.property(name, value)})},
        write_.numbers(Doubles{1, 2}));
  };
  for (const char* name : {"wf_increment", "NI_Scale[0]_Linear_Slope"}) {
    const std::string first = segment(name, 0.25);
    EXPECT_EQ(samples(first + first, "1").size(), 4U);
    expect_refused(first + segment(name, 0.5), "1",
                   std::string("channel g/a changes its ") + name +
                       " between its values; save each part as a file of its own");
  }
  // Other properties may change. A rate may also be corrected before the first values.
  EXPECT_EQ(samples(segment("wf_start_offset", 0) + segment("wf_start_offset", 1), "1").size(), 4U);
  const std::string planned = write_.segment(
      tdms::metadata | tdms::new_list,
      {write_.object(path, write_.no_values(), {write_.property("wf_increment", 1.0)})}, "");
  EXPECT_EQ(read_tdms(written(planned + segment("wf_increment", 0.25)), "1").sample_rate_hz, 4);
}

TEST_F(Tdms, MayChangeWhatDoesNotAffectTheChannel) {
  const auto segment = [&](const std::vector<std::string>& of_file,
                           const std::vector<std::string>& of_a,
                           const std::vector<std::string>& of_b = {}) {
    const std::string index = write_.index(tdms::dbl, 1);
    return write_.segment(
        tdms::new_values,
        {write_.object("/", write_.no_values(), of_file), write_.object("/'g'/'a'", index, of_a),
         write_.object("/'g'/'b'", index, of_b)},
        write_.numbers(Doubles{1, 2}));
  };
  const auto rate = [&](double seconds) {
    return std::vector{write_.property("wf_increment", seconds)};
  };
  const auto slope = [&](double value) {
    return std::vector{write_.property("NI_Scale[0]_Linear_Slope", value)};
  };
  const auto status = [&](const std::string& value) {
    return std::vector{write_.property("NI_Scaling_Status", value)};
  };
  const std::string why = " between its values; save each part as a file of its own";
  // Other channels, and a rate of the file.
  const std::string other = segment({}, rate(0.25), rate(1)) + segment({}, {}, rate(0.5));
  EXPECT_EQ(samples(other, "g/a").size(), 2U);
  expect_refused(other, "g/b", "channel g/b changes its wf_increment" + why);
  EXPECT_EQ(samples(segment(rate(1), {}) + segment(rate(0.5), {}), "1").size(), 2U);
  // Scales of the file count for each channel.
  expect_refused(segment(slope(1), {}) + segment(slope(0.5), {}), "1",
                 "channel g/a changes its NI_Scale[0]_Linear_Slope" + why);
  // Rounding, but not the sum of small steps.
  const std::string first = segment({}, rate(0.001));
  EXPECT_EQ(samples(first + segment({}, rate(0.0010000000000000002)), "1").size(), 2U);
  expect_refused(first + segment({}, rate(0.00100000001)), "1", "channel g/a changes its wf_");
  expect_refused(
      first + segment({}, rate(0.001 * (1 + 6e-10))) + segment({}, rate(0.001 * (1 + 12e-10))), "1",
      "channel g/a changes its wf_");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(samples(segment({}, slope(nan)) + segment({}, slope(nan)), "1").size(), 2U);
  for (const double one : {nan, infinite, -infinite}) {
    expect_refused(segment({}, slope(1)) + segment({}, slope(one)), "1", "channel g/a changes its");
  }
  // A rate that is set later.
  const std::string late = segment({}, rate(0)) + segment({}, rate(0.25));
  EXPECT_EQ(read_tdms(written(late), "1").sample_rate_hz, 4);
  expect_refused(late + segment({}, rate(0.5)), "1", "channel g/a changes its wf_increment" + why);
  expect_refused(first + segment({}, rate(0)), "1", "channel g/a changes its wf_increment" + why);
  // A scaling status without scales; with scales, it decides whether they apply.
  EXPECT_EQ(samples(segment({}, status("unscaled")) + segment({}, status("scaled")), "1").size(),
            2U);
  const std::string scaled = segment(slope(2), status("unscaled"));
  expect_refused(scaled + segment({}, status("scaled")), "1",
                 "channel g/a changes its NI_Scaling_Status" + why);
}

TEST_F(Tdms, IsRefusedIfItHoldsRawDaqmxData) {
  const std::string scaler = write_.number(std::uint32_t{0x1269}) + std::string(30, '\1');
  for (const std::uint32_t contents : {tdms::new_values | tdms::daqmx, tdms::new_values}) {
    expect_refused(write_.segment(contents, {write_.object("/'g'/'a'", scaler)}, "1234"), "1",
                   "holds raw data of NI-DAQmx, which are not supported; save the scaled channel");
  }
}

TEST_F(Tdms, RefusesItsIndexFile) {
  EXPECT_ERROR(read_here(folder_.write("a.tdms_index", "TDSh" + std::string(24, '\0')), "1"),
               Exit::bad_input, "is the index of a TDMS file: name the file that ends in .tdms");
}

}  // namespace
}  // namespace piae::raw
