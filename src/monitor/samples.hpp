#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/options.hpp"

namespace piae::monitor {

/// How a stream holds its samples. Binary ones are in the byte order of this machine and stand one
/// behind the other; text is one number a line.
enum class SampleFormat { f32, f64, i16, i32, text };

std::vector<cli::Word<SampleFormat>> sample_format_words();

/// Makes numbers of the bytes of a stream, which come in pieces that may end within a sample.
class SampleDecoder {
 public:
  /// `name` is the stream's, for messages.
  SampleDecoder(SampleFormat format, std::string name) : format_(format), name_(std::move(name)) {}

  /// Appends the samples of what came until now. Throws Error(bad_input) for a line that is not a
  /// number; empty lines are passed over.
  void add(std::span<const std::byte> bytes, std::vector<double>& samples);
  /// When no more bytes will come: a last line of text need not end.
  void finish(std::vector<double>& samples);
  /// Bytes of a sample that has not come whole.
  [[nodiscard]] std::size_t waiting() const { return begun_.size(); }
  void restart() { begun_.clear(); }

 private:
  template <class T>
  void add_binary(std::span<const std::byte> bytes, std::vector<double>& samples);
  void add_text(std::span<const std::byte> bytes, std::vector<double>& samples);
  void end_line(std::vector<double>& samples);

  SampleFormat format_;
  std::string name_;
  std::string begun_;
  std::uint64_t line_ = 0;
};

}  // namespace piae::monitor
