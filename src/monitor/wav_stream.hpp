#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace piae::monitor {

/// Number format of a WAV stream: signed integers of 16, 24 or 32 bits, or floats of 32 or 64.
struct WavCoding {
  bool is_float = false;
  unsigned bits = 0;
};

/// Finds the samples in the bytes of a WAV stream (RIFF, one channel), which arrive in pieces.
/// Recorders that write into a pipe do not know its length. Lengths of 0 and from 0x7FFF0000 on
/// therefore mean that samples continue to the end of the stream.
class WavStream {
 public:
  /// `name` is the stream's name in messages; its header must have the rate `rate_hz`.
  WavStream(std::string name, double rate_hz) : name_(std::move(name)), rate_hz_(rate_hz) {}

  /// Takes bytes from the front of `bytes` up to the end of the next samples, and returns the
  /// samples. Returns an empty span if `bytes` has none. Throws Error(bad_input) if the stream is
  /// not WAV, is damaged, has another rate or coding, several channels or a second recording.
  std::span<const std::byte> next(std::span<const std::byte>& bytes);

  /// Returns the coding; known as soon as samples have arrived.
  [[nodiscard]] const WavCoding& coding() const { return coding_; }
  /// Returns the number of sample bytes that the header promises and that have not arrived.
  [[nodiscard]] std::uint64_t missing() const;

  void restart() { *this = WavStream(name_, rate_hz_); }

 private:
  enum class Part { beginning, chunk, format, skipped, samples };

  void expect(Part part, std::uint64_t bytes);
  void skip(std::uint64_t bytes);
  void read_part();
  void read_chunk();
  void read_format();
  [[nodiscard]] std::uint32_t number_at(std::size_t at, std::size_t bytes) const;
  [[nodiscard]] bool has_text_at(std::size_t at, const char* text) const;
  [[noreturn]] void refuse(const std::string& what) const;

  std::string name_;
  double rate_hz_;
  Part part_ = Part::beginning;
  std::uint64_t left_ = 12;  ///< bytes of this part that have not arrived
  std::string held_;         ///< bytes of a part that is read as a whole
  WavCoding coding_;
  bool has_samples_ = false;
  bool endless_ = false;
};

}  // namespace piae::monitor
