#include "raw/flac_sum.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <vector>

#include "raw/file.hpp"

namespace piae::raw {

namespace {

constexpr std::size_t sum_bytes = 16;

/// Header block STREAMINFO (RFC 9639, 8.2), the needed fields only.
struct StreamInfo {
  int bits = 0;  ///< per sample
  std::array<unsigned char, sum_bytes> sum{};
};

StreamInfo stream_info(const std::filesystem::path& file) {
  std::array<char, 42> bytes{};
  std::ifstream(file, std::ios::binary).read(bytes.data(), bytes.size());
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes.at(i)); };
  StreamInfo info{.bits = ((byte(20) & 1) << 4 | byte(21) >> 4) + 1};
  for (std::size_t i = 0; i < sum_bytes; ++i) info.sum.at(i) = byte(26 + i);
  return info;
}

/// Returns the samples as the MD5 sum covers them: channels interleaved, low byte first.
std::vector<unsigned char> summed_bytes(SNDFILE* sound, const SF_INFO& info, int bits) {
  std::vector<int> samples(static_cast<std::size_t>(info.frames * info.channels));
  sf_seek(sound, 0, SEEK_SET);
  sf_readf_int(sound, samples.data(), info.frames);
  std::vector<unsigned char> bytes;
  bytes.reserve(samples.size() * static_cast<std::size_t>(bits / 8));
  for (const int sample : samples) {  // libsndfile scales samples to 32 bits
    for (int shift = 32 - bits; shift < 32; shift += 8) {
      bytes.push_back(static_cast<unsigned char>(static_cast<unsigned>(sample) >> shift));
    }
  }
  return bytes;
}

}  // namespace

void require_flac_sum(const std::filesystem::path& file, SNDFILE* sound, const SF_INFO& info) {
  const StreamInfo stated = stream_info(file);
  const bool has_sum =
      std::ranges::any_of(stated.sum, [](unsigned char byte) { return byte != 0; });
  if (!has_sum || stated.bits % 8 != 0) return;
  const std::vector<unsigned char> bytes = summed_bytes(sound, info, stated.bits);
  std::array<unsigned char, sum_bytes> sum{};
  unsigned size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), sum.data(), &size, EVP_md5(), nullptr) != 1) return;
  if (sum != stated.sum) refuse_file(file, "damaged: the MD5 sum of its samples does not match");
}

}  // namespace piae::raw
