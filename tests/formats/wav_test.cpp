#include "formats/wav.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "formats/exported_windows.hpp"

namespace piae::formats {
namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at, std::size_t size = 4) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + i))) << (8 * i);
  }
  return number;
}

/// Returns the chunks from a position on, each with its name, in order.
std::vector<std::pair<std::string, std::string>> chunks_of(const std::string& bytes,
                                                           std::size_t at) {
  std::vector<std::pair<std::string, std::string>> chunks;
  while (at < bytes.size()) {
    const std::size_t size = number_at(bytes, at + 4);
    chunks.emplace_back(bytes.substr(at, 4), bytes.substr(at + 8, size));
    at += 8 + size + size % 2;
  }
  EXPECT_EQ(at, bytes.size());
  return chunks;
}

TEST(Wav, HoldsTheSamplesAsFloatsOfOneChannel) {
  const std::string file = wav(exported_windows());
  EXPECT_EQ(file.substr(0, 4) + file.substr(8, 4), "RIFFWAVE");
  EXPECT_EQ(number_at(file, 4), file.size() - 8);
  std::map<std::string, std::string> chunks;
  for (const auto& [name, content] : chunks_of(file, 12)) chunks[name] = content;
  const std::string& format = chunks.at("fmt ");
  EXPECT_EQ(number_at(format, 0, 2), 3U);  // IEEE float
  EXPECT_EQ(number_at(format, 2, 2), 1U);
  EXPECT_EQ(number_at(format, 4), 12000U);
  EXPECT_EQ(number_at(format, 8), 48000U);
  EXPECT_EQ(number_at(format, 12, 2), 4U);
  EXPECT_EQ(number_at(format, 14, 2), 32U);
  EXPECT_EQ(number_at(chunks.at("fact"), 0), 8U);
  std::vector<float> samples(8);
  ASSERT_EQ(chunks.at("data").size(), 8 * sizeof(float));
  std::memcpy(samples.data(), chunks.at("data").data(), 8 * sizeof(float));
  EXPECT_EQ(samples, four_windows().samples);
}

TEST(Wav, MarksTheStartOfEachWindow) {
  std::map<std::string, std::string> chunks;
  for (const auto& [name, content] : chunks_of(wav(select(four_windows(), {"OR"}, 0)), 12)) {
    chunks[name] = content;
  }
  const std::string& cue = chunks.at("cue ");
  ASSERT_EQ(cue.size(), 4U + 2 * 24);
  EXPECT_EQ(number_at(cue, 0), 2U);
  EXPECT_EQ(number_at(cue, 4), 1U);
  EXPECT_EQ(number_at(cue, 4 + 20), 0U);
  EXPECT_EQ(number_at(cue, 28), 2U);
  EXPECT_EQ(number_at(cue, 28 + 20), 2U);
  const std::string& list = chunks.at("LIST");
  EXPECT_EQ(list.substr(0, 4), "adtl");
  const auto labels = chunks_of(list, 4);
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0].first, "labl");
  EXPECT_EQ(labels[0].second, std::string("\x01\0\0\0OR 2\0", 9));
  EXPECT_EQ(labels[1].second, std::string("\x02\0\0\0OR 3\0", 9));
}

TEST(Wav, RoundsTheRateToWholeHz) {
  Exported exported = exported_windows();
  exported.windows.info.sample_rate_hz = 25641.6;
  EXPECT_EQ(number_at(chunks_of(wav(exported), 12).front().second, 4), 25642U);
}

}  // namespace
}  // namespace piae::formats
