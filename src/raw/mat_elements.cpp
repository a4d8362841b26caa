#include "raw/mat_elements.hpp"

#include <zlib.h>

#include <array>
#include <cstdint>

#include "raw/bytes.hpp"

namespace piae::raw {

namespace {

constexpr std::uint32_t compressed = 15;  // miCOMPRESSED

bool is_big_endian(std::span<const std::byte> bytes) { return bytes[126] == std::byte{'M'}; }

/// Unpacks a zlib stream, keeps nothing of it, and says if its checksum is right.
bool is_intact_stream(std::span<const std::byte> packed) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return false;
  // zlib does not write there, but has no const.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::array<Bytef, 1 << 16> unpacked{};
  int result = Z_OK;
  while (result == Z_OK) {
    stream.next_out = unpacked.data();
    stream.avail_out = unpacked.size();
    result = inflate(&stream, Z_NO_FLUSH);
  }
  inflateEnd(&stream);
  return result == Z_STREAM_END;
}

}  // namespace

int mat_version(std::span<const std::byte> bytes) {
  if (bytes.size() < mat_header_bytes) return 0;
  const auto at = [&](std::size_t i) { return std::to_integer<int>(bytes[i]); };
  if (at(126) == 'M' && at(127) == 'I') return at(124) * 256 + at(125);
  if (at(126) == 'I' && at(127) == 'M') return at(125) * 256 + at(124);
  return 0;
}

bool is_whole_v5(std::span<const std::byte> bytes) {
  const bool big_endian = is_big_endian(bytes);
  std::size_t at = mat_header_bytes;
  while (at + 8 <= bytes.size()) at += 8 + number_at(bytes, at + 4, big_endian);
  return at == bytes.size();
}

bool is_intact_v5(std::span<const std::byte> bytes) {
  const bool big_endian = is_big_endian(bytes);
  for (std::size_t at = mat_header_bytes; at < bytes.size();) {
    const std::size_t size = number_at(bytes, at + 4, big_endian);
    const bool is_packed = number_at(bytes, at, big_endian) == compressed;
    if (is_packed && !is_intact_stream(bytes.subspan(at + 8, size))) return false;
    at += 8 + size;
  }
  return true;
}

}  // namespace piae::raw
