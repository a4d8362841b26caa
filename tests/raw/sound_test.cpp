#include "raw/sound.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include <cmath>
#include <cstdint>

#include "raw/file.hpp"
#include "support/errors.hpp"
#include "support/folder.hpp"

namespace piae::raw {
namespace {

namespace fs = std::filesystem;

constexpr int rate_hz = 48000;
constexpr std::size_t length = 3000;

/// Returns a 16-bit sample of the first channel; the second one has its negative.
std::int16_t sample(std::size_t i) {
  return static_cast<std::int16_t>(20000 * std::sin(0.01 * static_cast<double>(i * i)));
}

/// Returns a number in 2 or 4 bytes, low byte first.
std::string little(std::uint32_t number, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i));
  return text;
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
fs::path written(const fs::path& file, int format) {
  SF_INFO info{};
  info.samplerate = rate_hz;
  info.channels = 2;
  info.format = format | SF_FORMAT_PCM_16;
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

TEST(Sound, IsRefusedWithARepairIfItsLengthWasNeverWritten) {
  const Folder folder;
  std::string bytes = wav();
  bytes.replace(bytes.find("data") + 4, 4, std::string(4, '\0'));
  EXPECT_ERROR(read_here(folder.write("a.wav", bytes), "1"), Exit::bad_input,
               "sox --ignore-length");
}

}  // namespace
}  // namespace piae::raw
