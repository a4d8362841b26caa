#include "monitor/wav_stream.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace piae::monitor {

namespace {

constexpr std::uint64_t shortest_format = 16;
constexpr std::uint64_t longest_format = 4096;
constexpr std::uint32_t shortest_unknown =
    0x7FFF0000;  // sox writes 0x7FFFF000 less a part of a sample

constexpr std::uint32_t whole_numbers = 1;
constexpr std::uint32_t floats = 3;
constexpr std::uint32_t extensible = 0xFFFE;  // coding is in the extension

/// Returns the length with padding: chunks end at an even byte.
std::uint64_t padded(std::uint64_t bytes) { return bytes + bytes % 2; }

}  // namespace

std::span<const std::byte> WavStream::next(std::span<const std::byte>& bytes) {
  while (!bytes.empty()) {
    const bool no_end = part_ == Part::samples && endless_;
    const auto count = no_end
                           ? bytes.size()
                           : static_cast<std::size_t>(std::min<std::uint64_t>(left_, bytes.size()));
    const std::span<const std::byte> taken = bytes.first(count);
    bytes = bytes.subspan(count);
    if (no_end) return taken;
    left_ -= count;
    if (part_ == Part::samples) {
      if (left_ == 0) skip(0);
      return taken;
    }
    if (part_ != Part::skipped) held_.append(reinterpret_cast<const char*>(taken.data()), count);
    if (left_ == 0) read_part();
  }
  return {};
}

std::uint64_t WavStream::missing() const { return part_ == Part::samples && !endless_ ? left_ : 0; }

void WavStream::expect(Part part, std::uint64_t bytes) {
  part_ = part;
  left_ = bytes;
  held_.clear();
}

void WavStream::skip(std::uint64_t bytes) {
  if (bytes == 0) return expect(Part::chunk, 8);
  expect(Part::skipped, bytes);
}

void WavStream::read_part() {
  switch (part_) {
    case Part::beginning:
      if (has_text_at(0, "RF64")) refuse("is RF64, not WAV; convert it: sox FILE -t wav -");
      if (!has_text_at(0, "RIFF") || !has_text_at(8, "WAVE")) {
        refuse("does not begin like WAV (RIFF, WAVE); for raw samples write --format f32");
      }
      return expect(Part::chunk, 8);
    case Part::chunk:
      return read_chunk();
    case Part::format:
      read_format();
      return expect(Part::chunk, 8);
    case Part::skipped:
    case Part::samples:
      return expect(Part::chunk, 8);
  }
}

void WavStream::read_chunk() {
  const std::uint32_t length = number_at(4, 4);
  if (has_text_at(0, "RIFF") || (has_text_at(0, "data") && has_samples_)) {
    refuse("holds a second recording; pipe in only one, or raw samples");
  }
  if (has_text_at(0, "fmt ")) {
    if (length < shortest_format || length > longest_format) refuse("its WAV header is damaged");
    return expect(Part::format, padded(length));
  }
  if (has_text_at(0, "data")) {
    if (coding_.bits == 0) refuse("its WAV header does not declare the format of the samples");
    has_samples_ = true;
    endless_ = length == 0 || length >= shortest_unknown;
    return expect(Part::samples, length);
  }
  if (length >= shortest_unknown) refuse("its WAV header is damaged");
  skip(padded(length));
}

void WavStream::read_format() {
  constexpr std::size_t place_of_extension = 24;
  std::uint32_t kind = number_at(0, 2);
  if (kind == extensible && held_.size() >= place_of_extension + 2) {
    kind = number_at(place_of_extension, 2);
  }
  const std::uint32_t channels = number_at(2, 2);
  const std::uint32_t rate_hz = number_at(4, 4);
  const unsigned bits = number_at(14, 2);
  const bool is_float = kind == floats;
  const bool is_known = is_float
                            ? bits == 32 || bits == 64
                            : kind == whole_numbers && (bits == 16 || bits == 24 || bits == 32);
  if (channels != 1) {
    refuse(fmt::format("has {} channels; pipe in only one: sox FILE -t wav - remix 1", channels));
  }
  if (!is_known) {
    refuse(
        fmt::format("is WAV of kind {} with {} bits; supported are PCM of 16, 24, 32 bits and "
                    "floats of 32, 64; convert it: sox FILE -b 16 -t wav -",
                    kind, bits));
  }
  if (number_at(12, 2) != bits / 8) refuse("its WAV header is damaged");
  constexpr double rounding_hz = 0.5;
  if (std::abs(rate_hz - rate_hz_) > rounding_hz) {
    refuse(fmt::format(
        "its WAV header declares {} Hz, but --sample-rate-hz is {:g}; use the rate of the header",
        rate_hz, rate_hz_));
  }
  coding_ = {is_float, bits};
}

std::uint32_t WavStream::number_at(std::size_t at, std::size_t bytes) const {
  std::uint32_t number = 0;
  for (std::size_t i = bytes; i-- > 0;) {
    number = (number << 8U) | static_cast<unsigned char>(held_[at + i]);
  }
  return number;
}

bool WavStream::has_text_at(std::size_t at, const char* text) const {
  return held_.compare(at, 4, text) == 0;
}

void WavStream::refuse(const std::string& what) const {
  throw Error(Exit::bad_input, name_ + ": " + what);
}

}  // namespace piae::monitor
