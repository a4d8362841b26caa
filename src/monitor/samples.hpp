#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "monitor/text_samples.hpp"
#include "monitor/wav_stream.hpp"

namespace piae::monitor {

/// Format of a stream's samples. Binary samples follow each other directly, in the byte order of
/// this machine; "be" formats have the highest byte first. WAV has a header. Text is one number a
/// line.
enum class SampleFormat { f32, f64, f32be, f64be, i16, i32, wav, text };

std::vector<cli::Word<SampleFormat>> sample_format_words();

/// Decodes the bytes of a stream into numbers. Pieces of the stream may end within a sample.
class SampleDecoder {
 public:
  /// `name` is the stream's name in messages; a WAV header must have the rate `sample_rate_hz`.
  SampleDecoder(SampleFormat format, const std::string& name, double sample_rate_hz)
      : format_(format), name_(name), text_(name), wav_(name, sample_rate_hz) {}

  /// Appends the samples that are now complete. A line of text that is not a number becomes NaN.
  /// Throws like WavStream::next, and Error(bad_input) for text in a binary format and for a NumPy
  /// file.
  void add(std::span<const std::byte> bytes, std::vector<double>& samples);
  /// Appends the last sample at the end of the stream: a last line of text may lack its line end.
  void finish(std::vector<double>& samples);
  void restart();

  /// Returns the number of bytes of an incomplete sample.
  [[nodiscard]] std::size_t waiting() const { return waiting_.size() + text_.waiting(); }
  [[nodiscard]] const TextSamples& text() const { return text_; }
  [[nodiscard]] const WavStream& wav() const { return wav_; }
  /// Returns the format that fits the last bytes better if this format yields implausible numbers:
  /// "f32be" for f32, "wav" for a stream that starts with RIFF. Returns "" if there is none.
  [[nodiscard]] std::string likelier_format() const;

 private:
  template <class T, bool swapped = false>
  void add_values(std::span<const std::byte> bytes, std::vector<double>& samples);
  void add_wav(std::span<const std::byte> bytes, std::vector<double>& samples);
  template <std::size_t size, class Read>
  void add_binary(std::span<const std::byte> bytes, const Read& read);

  void note_recent(std::span<const std::byte> bytes);
  void require_binary() const;

  static constexpr std::size_t shown_bytes = 32;

  SampleFormat format_;
  std::string name_;
  TextSamples text_;
  WavStream wav_;
  std::string waiting_;
  std::string beginning_;  ///< first shown_bytes of the stream
  std::string recent_;     ///< the last bytes of the stream
};

}  // namespace piae::monitor
