#include "raw/sound.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"
#include "support/little_endian.hpp"

namespace piae::raw {
namespace {

namespace fs = std::filesystem;

constexpr int rate_hz = 48000;
constexpr std::size_t length = 10'000;  // more than a block

/// Returns a 16-bit sample of the first channel; the second one has its negative.
std::int16_t sample(std::size_t i) {
  return static_cast<std::int16_t>(20000 * std::sin(0.01 * static_cast<double>(i * i)));
}

/// Returns a WAV file (Microsoft and IBM, 1991): PCM, 16 bits.
std::string wav() {
  std::string data;
  for (std::size_t i = 0; i < length; ++i) {
    data += little(static_cast<std::uint16_t>(sample(i)), 2);
    data += little(static_cast<std::uint16_t>(-sample(i)), 2);
  }
  const std::string format = little(1, 2) + little(2, 2) + little(rate_hz, 4) +
                             little(4 * rate_hz, 4) + little(4, 2) + little(16, 2);
  const std::string chunks = "WAVEfmt " + little(16, 4) + format + "data" +
                             little(static_cast<std::uint32_t>(data.size()), 4) + data;
  return "RIFF" + little(static_cast<std::uint32_t>(chunks.size()), 4) + chunks;
}

/// Writes the same samples with libsndfile in another format.
fs::path written(const fs::path& file, int format, int samples_format = SF_FORMAT_PCM_16) {
  SF_INFO info{};
  info.samplerate = rate_hz;
  info.channels = samples_format == SF_FORMAT_GSM610 || samples_format == SF_FORMAT_G721_32 ? 1 : 2;
  info.format = format | samples_format;
  SNDFILE* const sound = sf_open(file.c_str(), SFM_WRITE, &info);
  std::vector<short> samples;
  for (std::size_t i = 0; i < length; ++i) {
    samples.push_back(sample(i));
    samples.push_back(static_cast<short>(-sample(i)));
  }
  sf_writef_short(sound, samples.data(), length);
  sf_close(sound);
  return file;
}

void expect_samples(const std::vector<double>& samples, double sign) {
  ASSERT_EQ(samples.size(), length);
  for (std::size_t i = 0; i < length; ++i) {
    ASSERT_EQ(samples[i], sign * sample(i) / 32768.0) << i;
  }
}

TEST(Sound, IsReadByChannelWithAFullScaleOf1) {
  const Folder folder;
  const fs::path file = folder.write("a.wav", wav());
  expect_samples(read_here(file, "1"), 1);
  expect_samples(read_here(file, "2"), -1);
  EXPECT_EQ(read_sound(file, "1").sample_rate_hz, rate_hz);
}

TEST(Sound, IsReadInAnyFormatWhateverItsName) {
  const Folder folder;
  for (const int format :
       {SF_FORMAT_WAV, SF_FORMAT_AIFF, SF_FORMAT_W64, SF_FORMAT_RF64, SF_FORMAT_FLAC}) {
    SCOPED_TRACE(format);
    expect_samples(read_here(written(folder / "recording", format), "2"), -1);
  }
}

TEST(Sound, MustHaveTheExpectedRate) {
  const Folder folder;
  const fs::path file = folder.write("a.wav", wav());
  expect_samples(read_here(file, "1", rate_hz), 1);
  EXPECT_ERROR(read_here(file, "1", 12000), Exit::bad_input,
               "a.wav: declares a sample rate of 48000 Hz, not 12000 Hz");
}

TEST(Sound, HasNumberedChannels) {
  const Folder folder;
  const fs::path file = folder.write("a.wav", wav());
  for (const char* channel : {"0", "3", "left", ""}) {
    EXPECT_ERROR(
        read_here(file, channel), Exit::bad_input,
        std::string("a.wav: has no channel ") + channel + "; name a channel by its number, 1 to 2");
  }
}

TEST(Sound, IsRefusedIfTruncated) {
  const Folder folder;
  for (const int format :
       {SF_FORMAT_WAV, SF_FORMAT_AIFF, SF_FORMAT_FLAC, SF_FORMAT_W64, SF_FORMAT_RF64}) {
    const fs::path file = written(folder / "a", format);
    const auto whole = fs::file_size(file);
    SCOPED_TRACE(format);
    for (const auto size : {whole - 2, whole / 2, std::uintmax_t{60}}) {
      fs::resize_file(file, size);
      EXPECT_ERROR(read_here(file, "1"), Exit::bad_input, file.string());
    }
  }
}

/// Flips one bit in the size of the samples, which no checksum covers.
TEST(Sound, IsRefusedIfItsLengthContradictsTheHeader) {
  const Folder folder;
  std::string bytes = wav();
  const std::size_t size = bytes.find("data") + 4;
  for (const int bit : {3, 4, 9, 12}) {
    std::string damaged = bytes;
    const std::size_t at = size + static_cast<std::size_t>(bit) / 8;
    damaged[at] = static_cast<char>(damaged[at] ^ 1 << bit % 8);
    EXPECT_ERROR(read_here(folder.write("a.wav", damaged), "1"), Exit::bad_input, "damaged: it");
  }
  // Other chunks may follow.
  const std::string more = "LIST" + little(4, 4) + "INFO";
  std::string longer = bytes + more;
  longer.replace(4, 4, little(static_cast<std::uint32_t>(longer.size() - 8), 4));
  expect_samples(read_here(folder.write("a.wav", longer), "1"), 1);
  // A file may end with anything if its header declares another file size.
  longer = bytes + "xx";
  expect_samples(read_here(folder.write("a.wav", longer), "1"), 1);
}

/// Returns a number in 2 or 4 bytes, high byte first.
std::string big(std::uint32_t number, std::size_t bytes) {
  std::string text = little(number, bytes);
  std::ranges::reverse(text);
  return text;
}

/// Returns an AIFF file (Apple, 1989): 16 bits, two channels. The samples start `offset` bytes
/// after the head of their chunk, which declares `declared`.
std::string aiff(std::uint32_t offset, std::uint32_t declared) {
  std::string data = big(declared, 4) + big(0, 4) + std::string(offset, '\x55');
  for (std::size_t i = 0; i < length; ++i) {
    data += big(static_cast<std::uint16_t>(sample(i)), 2);
    data += big(static_cast<std::uint16_t>(-sample(i)), 2);
  }
  const std::string rate("\x40\x0e\xbb\x80\0\0\0\0\0\0", 10);  // 48000 as an 80-bit float
  const std::string chunks = "AIFFCOMM" + big(18, 4) + big(2, 2) + big(length, 4) + big(16, 2) +
                             rate + "SSND" + big(static_cast<std::uint32_t>(data.size()), 4) + data;
  return "FORM" + big(static_cast<std::uint32_t>(chunks.size()), 4) + chunks;
}

TEST(Sound, StartsInAiffAtTheDeclaredOffset) {
  const Folder folder;
  for (const std::uint32_t offset : {0, 4, 8, 512}) {
    SCOPED_TRACE(offset);
    const fs::path file = folder.write("a.aiff", aiff(offset, offset));
    expect_samples(read_here(file, "1"), 1);
    expect_samples(read_here(file, "2"), -1);
    for (const int bit : {0, 1, 3, 10, 31}) {
      EXPECT_ERROR(read_here(folder.write("a.aiff", aiff(offset, offset ^ 1U << bit)), "1"),
                   Exit::bad_input, "a.aiff: damaged: its channels, bits or length contradict");
    }
  }
}

/// RF64 (EBU Tech 3306) declares the file's bytes, the samples' bytes and the number of frames in
/// its chunk ds64.
TEST(Sound, IsRefusedInRf64IfItsLengthsContradict) {
  const Folder folder;
  std::string bytes = bytes_of(written(folder / "a", SF_FORMAT_RF64));
  const std::size_t sizes = bytes.find("ds64") + 8;
  ASSERT_EQ(bytes.substr(sizes, 4),
            little(static_cast<std::uint32_t>(bytes.size()) - 8, 4));  // of the file
  ASSERT_EQ(bytes.substr(sizes + 8, 4), little(4 * length, 4));
  ASSERT_EQ(bytes.substr(sizes + 16, 4), little(length, 4));
  const auto with = [&](std::size_t at, std::uint32_t number) {
    std::string other = bytes;
    return folder.write("a", other.replace(sizes + at, 4, little(number, 4)));
  };
  for (const std::uint32_t fewer : {4U, 1024U, 8192U}) {
    EXPECT_ERROR(read_here(with(8, 4 * length - fewer), "1"), Exit::bad_input, "a: damaged: its");
    EXPECT_ERROR(read_here(with(16, length - fewer), "1"), Exit::bad_input, "a: damaged: its");
  }
  // Recorders may leave out the number of frames, which only compressed samples need, or count the
  // samples of both channels.
  expect_samples(read_here(with(16, 0), "1"), 1);
  expect_samples(read_here(with(16, 2 * length), "1"), 1);
  EXPECT_ERROR(read_here(with(16, 3 * length), "1"), Exit::bad_input, "a: damaged: its");
  bytes.replace(sizes + 20, 4, 4, '\xff');
  expect_samples(read_here(with(16, 0xFFFFFFFF), "1"), 1);
}

TEST(Sound, IsRefusedWithLossyCompressionInAnyContainer) {
  const Folder folder;
  const auto formats = {
      std::pair{SF_FORMAT_WAV, SF_FORMAT_ULAW}, {SF_FORMAT_WAV, SF_FORMAT_ALAW},
      {SF_FORMAT_WAV, SF_FORMAT_IMA_ADPCM},     {SF_FORMAT_WAV, SF_FORMAT_MS_ADPCM},
      {SF_FORMAT_WAV, SF_FORMAT_GSM610},        {SF_FORMAT_WAV, SF_FORMAT_G721_32},
      {SF_FORMAT_W64, SF_FORMAT_ULAW},          {SF_FORMAT_W64, SF_FORMAT_IMA_ADPCM},
      {SF_FORMAT_RF64, SF_FORMAT_ALAW},         {SF_FORMAT_AIFF, SF_FORMAT_ULAW},
      {SF_FORMAT_AIFF, SF_FORMAT_GSM610},       {SF_FORMAT_AIFF, SF_FORMAT_IMA_ADPCM}};
  for (const auto& [container, samples] : formats) {
    SCOPED_TRACE(std::to_string(container) + ' ' + std::to_string(samples));
    EXPECT_ERROR(read_here(written(folder / "a", container, samples), "1"), Exit::bad_input,
                 "a: is sound with lossy compression, which changes vibration; record WAV");
  }
  for (const int samples :
       {SF_FORMAT_PCM_24, SF_FORMAT_PCM_32, SF_FORMAT_FLOAT, SF_FORMAT_DOUBLE}) {
    for (const int container : {SF_FORMAT_WAV, SF_FORMAT_W64, SF_FORMAT_RF64, SF_FORMAT_AIFF}) {
      SCOPED_TRACE(std::to_string(container) + ' ' + std::to_string(samples));
      EXPECT_EQ(read_here(written(folder / "a", container, samples), "2").size(), length);
    }
  }
  // A damaged kind: mu-law has one byte a sample, so there would be four times as many.
  std::string bytes = bytes_of(written(folder / "a", SF_FORMAT_WAV, SF_FORMAT_FLOAT));
  bytes.replace(bytes.find("fmt ") + 8, 2, little(7, 2));
  EXPECT_ERROR(read_here(folder.write("a", bytes), "1"), Exit::bad_input, "a: ");
}

TEST(Sound, IsRefusedWithARepairIfItsLengthWasNeverWritten) {
  const Folder folder;
  std::string bytes = wav();
  bytes.replace(bytes.find("data") + 4, 4, std::string(4, '\0'));
  EXPECT_ERROR(read_here(folder.write("a.wav", bytes), "1"), Exit::bad_input,
               "sox --ignore-length");
}

TEST(Sound, IsRefusedWithoutARate) {
  const Folder folder;
  std::string bytes = wav();
  for (std::size_t i = 24; i < 28; ++i) bytes[i] = '\0';
  EXPECT_ERROR(read_here(folder.write("a.wav", bytes), "1"), Exit::bad_input,
               "a.wav: declares a sample rate of 0 Hz; correct its header: sox -r RATE");
}

}  // namespace
}  // namespace piae::raw
