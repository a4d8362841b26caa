#include "monitor/wav_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "monitor/samples.hpp"
#include "support/errors.hpp"
#include "support/little_endian.hpp"

namespace piae::monitor {
namespace {

using Numbers = std::vector<double>;

std::string chunk(const std::string& id, const std::string& body) {
  return id + little(body.size(), 4) + body + std::string(body.size() % 2, '\0');
}

std::string format_of(unsigned kind, unsigned bits, unsigned channels = 1,
                      unsigned rate_hz = 12000) {
  const unsigned align = channels * bits / 8;
  return little(kind, 2) + little(channels, 2) + little(rate_hz, 4) + little(rate_hz * align, 4) +
         little(align, 2) + little(bits, 2);
}

/// Returns a format chunk with the kind in an extension, as sox writes it for more than 16 bits.
std::string extensible_of(unsigned kind, unsigned bits) {
  const std::string rest("\0\0\0\0\x10\0\x80\0\0\xAA\0\x38\x9B\x71", 14);
  return format_of(0xFFFE, bits) + little(22, 2) + little(bits, 2) + little(4, 4) +
         little(kind, 2) + rest;
}

std::string riff(const std::string& chunks) {
  return "RIFF" + little(4 + chunks.size(), 4) + "WAVE" + chunks;
}

std::string wav_of(const std::string& format, const std::string& samples) {
  return riff(chunk("fmt ", format) + chunk("data", samples));
}

Numbers decoded_wav(const std::string& bytes, std::size_t piece = 1000, double rate_hz = 12000) {
  SampleDecoder decoder(SampleFormat::wav, "raw", rate_hz);
  Numbers samples;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    decoder.add(std::as_bytes(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at))),
                samples);
  }
  decoder.finish(samples);
  return samples;
}

/// Full scale is 1, as for recordings in files: 0x4000 in 16 bits is 0.5.
TEST(WavStream, ReadsEachCodingInAnyPieces) {
  const std::string of_16 =
      wav_of(format_of(1, 16), little(0x4000, 2) + little(0x8000, 2) + little(1, 2));
  const std::string of_24 = wav_of(extensible_of(1, 24), little(0x400000, 3) + little(0xFFFFFF, 3));
  const std::string of_32 = wav_of(format_of(1, 32), little(0xC0000000, 4));
  const std::string floats =
      wav_of(format_of(3, 32), little(0x3FC00000, 4) + little(0xC0100000, 4));
  const std::string doubles = wav_of(extensible_of(3, 64), little(0x3FF8000000000000, 8));
  for (const std::size_t piece : {1, 2, 3, 5, 7, 44, 45, 1000}) {
    SCOPED_TRACE(piece);
    EXPECT_EQ(decoded_wav(of_16, piece), (Numbers{0.5, -1, 1.0 / 32768}));
    EXPECT_EQ(decoded_wav(of_24, piece), (Numbers{0.5, -1.0 / 8388608}));
    EXPECT_EQ(decoded_wav(of_32, piece), (Numbers{-0.5}));
    EXPECT_EQ(decoded_wav(floats, piece), (Numbers{1.5, -2.25}));
    EXPECT_EQ(decoded_wav(doubles, piece), (Numbers{1.5}));
  }
}

TEST(WavStream, SkipsOtherChunks) {
  const std::string samples = little(0x4000, 2);
  const std::string bytes = riff(chunk("JUNK", std::string(29, 'x')) + chunk("LIST", "") +
                                 chunk("fmt ", format_of(1, 16)) + chunk("fact", little(1, 4)) +
                                 chunk("data", samples) + chunk("LIST", "made by data RIFF"));
  for (const std::size_t piece : {1, 3, 1000}) {
    EXPECT_EQ(decoded_wav(bytes, piece), (Numbers{0.5})) << piece;
  }
}

/// Recorders that write into a pipe do not know its end.
TEST(WavStream, ReadsUnknownLengthsToTheEnd) {
  std::string samples;
  for (int i = 0; i < 5000; ++i) samples += little(0x4000, 2);
  for (const std::uint64_t length :
       {0U, 0x7FFFEFFFU, 0x7FFFF000U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU}) {
    const std::string bytes = "RIFF" + little(0xFFFFFFFF, 4) + "WAVE" +
                              chunk("fmt ", format_of(1, 16)) + "data" + little(length, 4) +
                              samples;
    EXPECT_EQ(decoded_wav(bytes, 999), Numbers(5000, 0.5)) << length;
  }
}

TEST(WavStream, ReportsMissingBytes) {
  std::string bytes = wav_of(format_of(1, 16), std::string(100, '\1'));
  bytes.resize(bytes.size() - 30);
  SampleDecoder decoder(SampleFormat::wav, "raw", 12000);
  Numbers samples;
  decoder.add(std::as_bytes(std::span(bytes)), samples);
  EXPECT_EQ(samples.size(), 35U);
  EXPECT_EQ(decoder.wav().missing(), 30U);
  decoder.restart();
  EXPECT_EQ(decoder.wav().missing(), 0U);
  const std::string whole = wav_of(format_of(1, 16), std::string(100, '\1'));
  decoder.add(std::as_bytes(std::span(whole)), samples);
  EXPECT_EQ(samples.size(), 85U);
  EXPECT_EQ(decoder.wav().missing(), 0U);
}

TEST(WavStream, RefusesUnsupportedStreams) {
  const std::string samples(8, '\1');
  EXPECT_ERROR(decoded_wav(wav_of(format_of(1, 16, 2), samples)), Exit::bad_input,
               "raw: has 2 channels; pipe in only one");
  EXPECT_ERROR(decoded_wav(wav_of(format_of(1, 16, 1, 44100), samples)), Exit::bad_input,
               "its WAV header declares 44100 Hz, but --sample-rate-hz is 12000");
  EXPECT_ERROR(decoded_wav(wav_of(format_of(1, 8), samples)), Exit::bad_input,
               "is WAV of kind 1 with 8 bits");
  EXPECT_ERROR(decoded_wav(wav_of(format_of(6, 8), samples)), Exit::bad_input, "kind 6");
  EXPECT_ERROR(decoded_wav(wav_of(format_of(1, 16), samples) + wav_of(format_of(1, 16), samples)),
               Exit::bad_input, "holds a second recording");
  EXPECT_EQ(decoded_wav(wav_of(format_of(1, 16, 1, 12001), samples), 7, 12000.6).size(), 4U);
}

TEST(WavStream, RefusesDamage) {
  const std::string samples(8, '\1');
  EXPECT_ERROR(decoded_wav("0.1\n0.2\n0.3\n0.4\n"), Exit::bad_input, "does not begin like WAV");
  EXPECT_ERROR(decoded_wav("RIFX" + wav_of(format_of(1, 16), samples).substr(4)), Exit::bad_input,
               "does not begin like WAV");
  EXPECT_ERROR(decoded_wav("RF64" + wav_of(format_of(1, 16), samples).substr(4)), Exit::bad_input,
               "is RF64, not WAV; convert it: sox FILE -t wav -");
  EXPECT_ERROR(decoded_wav(riff(chunk("data", samples))), Exit::bad_input,
               "does not declare the format");
  EXPECT_ERROR(decoded_wav(riff(chunk("fmt ", "short"))), Exit::bad_input, "header is damaged");
  EXPECT_ERROR(decoded_wav(riff(chunk("fmt ", std::string(5000, '\1')))), Exit::bad_input,
               "header is damaged");
  EXPECT_ERROR(decoded_wav(riff("LIST" + little(0xFFFFFFFF, 4))), Exit::bad_input,
               "header is damaged");
  std::string other_align = format_of(1, 16);
  other_align[12] = 4;
  EXPECT_ERROR(decoded_wav(wav_of(other_align, samples)), Exit::bad_input, "header is damaged");
  EXPECT_ERROR(decoded_wav(wav_of(format_of(1, 16), samples) + chunk("data", samples)),
               Exit::bad_input, "holds a second recording");
}

/// A cut header yields no samples; a flipped bit throws nothing but Error(bad_input).
TEST(WavStream, ReadsDamagedHeadersSafely) {
  const std::string bytes = wav_of(extensible_of(1, 24), std::string(30, '\1'));
  const std::size_t header = bytes.size() - 30;
  for (std::size_t length = 0; length <= header; ++length) {
    EXPECT_TRUE(decoded_wav(bytes.substr(0, length), 5).empty()) << length;
  }
  for (std::size_t bit = 0; bit < 8 * header; ++bit) {
    std::string flipped = bytes;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    const auto error = error_of([&] { EXPECT_LE(decoded_wav(flipped, 5).size(), 15U) << bit; });
    EXPECT_EQ(error ? error->exit() : Exit::bad_input, Exit::bad_input) << bit;
  }
}

}  // namespace
}  // namespace piae::monitor
