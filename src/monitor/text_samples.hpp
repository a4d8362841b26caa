#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace piae::monitor {

/// Makes numbers of a text with one on each line, which comes in pieces.
class TextSamples {
 public:
  /// `name` is the stream's, for messages.
  explicit TextSamples(std::string name) : name_(std::move(name)) {}

  /// Appends the numbers of the lines that have ended. A line that is not a number takes the time
  /// of a sample, and gives NaN; empty lines are passed over.
  void add(std::span<const std::byte> bytes, std::vector<double>& samples);
  /// When no more bytes will come: a last line need not end.
  void finish(std::vector<double>& samples);
  void restart();

  /// Bytes of a line that has not ended.
  [[nodiscard]] std::size_t waiting() const { return line_.size(); }
  [[nodiscard]] std::uint64_t garbled() const { return garbled_; }
  /// The first line that is not a number: where and what it is. Empty while there is none.
  [[nodiscard]] const std::string& first_garbled() const { return first_garbled_; }

 private:
  void end_line(std::vector<double>& samples);

  std::string name_;
  std::string line_;
  bool is_too_long_ = false;
  std::uint64_t ended_ = 0;  ///< lines
  std::uint64_t garbled_ = 0;
  std::string first_garbled_;
};

}  // namespace piae::monitor
