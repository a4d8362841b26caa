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

/// The form in which a stream holds its samples. Binary ones are in the byte order of this machine,
/// those called "be" with the highest byte first, and stand one behind the other; WAV has a header;
/// text is one number a line.
enum class SampleFormat { f32, f64, f32be, f64be, i16, i32, wav, text };

std::vector<cli::Word<SampleFormat>> sample_format_words();

/// Makes numbers of the bytes of a stream, which come in pieces that may end within a sample.
class SampleDecoder {
 public:
  /// `name` is the stream's, for messages, and `sample_rate_hz` what a WAV header must say.
  SampleDecoder(SampleFormat format, const std::string& name, double sample_rate_hz)
      : format_(format), name_(name), text_(name), wav_(name, sample_rate_hz) {}

  /// Appends the samples of what came until now. A line of text that is not a number is NaN. Throws
  /// as WavStream::next, and Error(bad_input) for text where the format is a binary one,
  /// and for a file of NumPy.
  void add(std::span<const std::byte> bytes, std::vector<double>& samples);
  /// When no more bytes will come: a last line of text need not end.
  void finish(std::vector<double>& samples);
  void restart();

  /// Bytes of a sample that has not come whole.
  [[nodiscard]] std::size_t waiting() const { return waiting_.size() + text_.waiting(); }
  [[nodiscard]] const TextSamples& text() const { return text_; }
  [[nodiscard]] const WavStream& wav() const { return wav_; }
  /// The format that the last bytes rather look like, where this one makes odd numbers of them:
  /// "f32be" for f32, "wav" for a stream that begins like one. Empty where there is none.
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
  std::string beginning_;  ///< of the stream: shown_bytes
  std::string recent_;     ///< the last bytes of the stream
};

}  // namespace piae::monitor
