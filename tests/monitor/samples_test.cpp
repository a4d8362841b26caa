#include "monitor/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/error.hpp"
#include "base/random.hpp"
#include "support/errors.hpp"

namespace piae::monitor {
namespace {

using Numbers = std::vector<double>;

template <class T>
std::string as_bytes_of(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

constexpr double rate_hz = 12000;

void add(SampleDecoder& decoder, const std::string& bytes, Numbers& samples) {
  decoder.add(std::as_bytes(std::span(bytes)), samples);
}

Numbers decoded(SampleFormat format, const std::string& bytes, std::size_t piece) {
  SampleDecoder decoder(format, "raw", rate_hz);
  Numbers samples;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    add(decoder, bytes.substr(at, piece), samples);
  }
  decoder.finish(samples);
  return samples;
}

/// Reverses each group of `size` bytes.
std::string swapped(std::string bytes, std::size_t size) {
  for (auto at = bytes.begin(); at != bytes.end(); at += static_cast<std::ptrdiff_t>(size)) {
    std::reverse(at, at + static_cast<std::ptrdiff_t>(size));
  }
  return bytes;
}

TEST(Samples, DoNotDependOnThePieces) {
  for (const std::size_t piece : {1, 2, 3, 5, 7, 8, 11, 1000}) {
    SCOPED_TRACE(piece);
    EXPECT_EQ(decoded(SampleFormat::f32, as_bytes_of<float>({1.5F, -2.25F, 3e10F}), piece),
              (Numbers{1.5, -2.25, 3e10F}));
    EXPECT_EQ(decoded(SampleFormat::f64, as_bytes_of<double>({0.1, -1e300}), piece),
              (Numbers{0.1, -1e300}));
    EXPECT_EQ(decoded(SampleFormat::i16, as_bytes_of<std::int16_t>({1, -32768, 32767}), piece),
              (Numbers{1, -32768, 32767}));
    EXPECT_EQ(decoded(SampleFormat::i32, as_bytes_of<std::int32_t>({7, -2147483647}), piece),
              (Numbers{7, -2147483647}));
    EXPECT_EQ(decoded(SampleFormat::text, "1.5\n\n -2e3\t\r\n7", piece), (Numbers{1.5, -2000, 7}));
    // IEEE 754 by hand: 1.5 is 0x3FC00000, -2.25 is 0xC0100000; in 64 bits 0x3FF8..., 0xC002....
    EXPECT_EQ(decoded(SampleFormat::f32be, std::string("\x3F\xC0\0\0\xC0\x10\0\0", 8), piece),
              (Numbers{1.5, -2.25}));
    EXPECT_EQ(decoded(SampleFormat::f64be,
                      std::string("\x3F\xF8\0\0\0\0\0\0\xC0\x02\0\0\0\0\0\0", 16), piece),
              (Numbers{1.5, -2.25}));
  }
}

TEST(Samples, ReportAnUnfinishedSample) {
  SampleDecoder decoder(SampleFormat::f32, "raw", rate_hz);
  Numbers samples;
  add(decoder, std::string(7, '\0'), samples);
  EXPECT_EQ(samples.size(), 1U);
  EXPECT_EQ(decoder.waiting(), 3U);
  decoder.restart();
  EXPECT_EQ(decoder.waiting(), 0U);
}

TEST(Samples, HaveAGapAtAnInvalidLine) {
  SampleDecoder decoder(SampleFormat::text, "raw", rate_hz);
  Numbers samples;
  add(decoder, "+1\n2\n3,4\n+.5\n+-1\n", samples);
  EXPECT_EQ(samples.size(), 5U);
  EXPECT_EQ(samples[0], 1);
  EXPECT_TRUE(std::isnan(samples[2]));
  EXPECT_EQ(samples[3], 0.5);
  EXPECT_TRUE(std::isnan(samples[4]));
  EXPECT_EQ(decoder.text().garbled(), 2U);
  EXPECT_EQ(decoder.text().first_garbled(),
            "raw, line 3: '3,4' is not a number; a line of --format text must hold one sample");
}

/// Memory does not grow with the length of a line.
TEST(Samples, HaveAGapAtALongLine) {
  SampleDecoder decoder(SampleFormat::text, "raw", rate_hz);
  Numbers samples;
  for (int i = 0; i < 100; ++i) add(decoder, std::string(1000, '1'), samples);
  EXPECT_LE(decoder.waiting(), 100U);
  add(decoder, "\n7\n", samples);
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_TRUE(std::isnan(samples[0]));
  EXPECT_EQ(samples[1], 7);
  EXPECT_EQ(decoder.text().garbled(), 1U);
  EXPECT_NE(decoder.text().first_garbled().find("1...' is not a number"), std::string::npos);
}

/// Text read as binary yields numbers of all magnitudes.
TEST(Samples, AreNotReadAsBinaryIfText) {
  const std::string text = "0.0125\n-0.25\n+1.5e-3\n0.125\n-0.0625\n";
  for (const SampleFormat format : {SampleFormat::f32, SampleFormat::f64, SampleFormat::f32be,
                                    SampleFormat::i16, SampleFormat::i32}) {
    SampleDecoder decoder(format, "pump", 12000);
    std::vector<double> samples;
    const auto bytes = std::as_bytes(std::span(text));
    decoder.add(bytes.first(10), samples);
    EXPECT_ERROR(decoder.add(bytes.subspan(10), samples), Exit::bad_input,
                 "pump: begins like text, not like binary samples; is it --format text?");
  }
}

/// Reads samples of each format as every other one, as for an owner who forgets --format.
TEST(Samples, RevealTheirFormat) {
  std::vector<float> f32;
  std::vector<double> f64;
  std::vector<double> of_f32;
  std::vector<double> whole;
  std::vector<std::int16_t> i16;
  std::vector<std::int32_t> i32;
  Stream random("formats");
  for (int i = 0; i < 4000; ++i) {
    const double x = random.normal(0, 1);
    f32.push_back(static_cast<float>(x));
    f64.push_back(x);
    of_f32.push_back(f32.back());
    i16.push_back(static_cast<std::int16_t>(std::lround(1000 * x)));
    i32.push_back(static_cast<std::int32_t>(std::lround(1e6 * x)));
    whole.push_back(i16.back());
  }
  using Format = SampleFormat;
  const std::vector<std::tuple<std::string, std::string, std::vector<Format>>> cases{
      {"f32", as_bytes_of(f32), {Format::f32be, Format::f64be, Format::i16}},
      {"f64", as_bytes_of(f64), {Format::f32, Format::f32be, Format::f64be, Format::i16}},
      {"f64", as_bytes_of(of_f32), {Format::f32, Format::f32be, Format::f64be}},
      {"f64", as_bytes_of(whole), {Format::f32}},
      {"i16", as_bytes_of(i16), {Format::f32, Format::f64, Format::f32be, Format::i32}},
      {"i32", as_bytes_of(i32), {Format::f32, Format::f64, Format::i16}}};
  for (const auto& [right, bytes, wrong_ones] : cases) {
    for (const auto& [name, format] : sample_format_words()) {
      if (format == Format::text || format == Format::wav) continue;
      SampleDecoder decoder(format, "raw", rate_hz);
      Numbers samples;
      add(decoder, bytes, samples);
      const bool is_wrong = std::ranges::find(wrong_ones, format) != wrong_ones.end();
      if (!is_wrong && name != right) continue;
      EXPECT_EQ(decoder.likelier_format(), is_wrong ? right : "") << right << " read as " << name;
    }
  }
}

TEST(Samples, AreNotReadFromANumPyFile) {
  for (const auto format : {SampleFormat::f32, SampleFormat::f64, SampleFormat::text}) {
    SampleDecoder decoder(format, "pump", rate_hz);
    Numbers samples;
    EXPECT_ERROR(add(decoder, "\x93NUMPY\x01" + std::string(100, 'x'), samples), Exit::bad_input,
                 "pump: begins like a NumPy file; pipe in only its samples: python3 -c");
  }
}

/// Low halves of 24 bits fill their range, those of 16 bits in 32 are 0, and numbers within 16 bits
/// have high halves of 0 or -1.
TEST(Samples, Of32BitsAreNotTakenFor16) {
  Stream random("halves");
  for (const double scale : {300., 65536. * 1000, 256. * 10'000}) {
    std::vector<std::int32_t> samples;
    for (int i = 0; i < 4000; ++i) {
      const long whole = std::lround(random.normal(0, 1) * 1000);
      samples.push_back(static_cast<std::int32_t>(static_cast<double>(whole) * scale / 1000));
    }
    if (scale > 1e7) {
      for (std::int32_t& sample : samples) sample = sample / 65536 * 65536;
    }
    SampleDecoder decoder(SampleFormat::i32, "raw", rate_hz);
    Numbers numbers;
    add(decoder, as_bytes_of(samples), numbers);
    EXPECT_EQ(decoder.likelier_format(), "") << scale;
  }
}

TEST(Samples, MayStartWithAByteOrderMark) {
  SampleDecoder decoder(SampleFormat::text, "pump", rate_hz);
  Numbers samples;
  add(decoder, "\xEF\xBB\xBF", samples);
  add(decoder, "1\n2\n", samples);
  EXPECT_EQ(samples, (Numbers{1, 2}));
  EXPECT_EQ(decoder.text().garbled(), 0U);
  add(decoder,
      "\xEF\xBB\xBF"
      "3\n",
      samples);
  EXPECT_EQ(decoder.text().garbled(), 1U);  // only at the start
}

TEST(Samples, HaveNoGapAtABlankLine) {
  SampleDecoder decoder(SampleFormat::text, "pump", rate_hz);
  Numbers samples;
  add(decoder, "1\n\n2\r\n \t\r\n3\n" + std::string(300, ' ') + "\n4\n", samples);
  EXPECT_EQ(samples, (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(decoder.text().garbled(), 0U);
}

TEST(Samples, RevealTheirByteOrder) {
  std::vector<float> narrow;
  std::vector<double> wide;
  Stream random("byte order");
  for (int i = 0; i < 2000; ++i) {
    narrow.push_back(static_cast<float>(random.normal(0, 0.1)));
    wide.push_back(random.normal(0, 300));
  }
  const auto likelier = [](SampleFormat format, const std::string& bytes) {
    SampleDecoder decoder(format, "raw", rate_hz);
    Numbers samples;
    add(decoder, bytes, samples);
    return decoder.likelier_format();
  };
  const std::string f32 = as_bytes_of(narrow);
  const std::string f64 = as_bytes_of(wide);
  EXPECT_EQ(likelier(SampleFormat::f32, swapped(f32, 4)), "f32be");
  EXPECT_EQ(likelier(SampleFormat::f32be, f32), "f32");
  EXPECT_EQ(likelier(SampleFormat::f64, swapped(f64, 8)), "f64be");
  EXPECT_EQ(likelier(SampleFormat::f64be, f64), "f64");
  EXPECT_EQ(likelier(SampleFormat::f32, f32), "");
  EXPECT_EQ(likelier(SampleFormat::f64be, swapped(f64, 8)), "");
  EXPECT_EQ(likelier(SampleFormat::i16, f32), "f32");
  EXPECT_EQ(likelier(SampleFormat::f32, "RIFF" + std::string(400, '\xFF')), "wav");
  EXPECT_EQ(likelier(SampleFormat::f32, std::string(400, '\xFF')), "") << "NaN either way";
}

}  // namespace
}  // namespace piae::monitor
