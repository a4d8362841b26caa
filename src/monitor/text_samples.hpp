#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace piae::monitor {

/// Decodes text with one number a line, which arrives in pieces.
class TextSamples {
 public:
  /// `name` is the stream's name in messages.
  explicit TextSamples(std::string name) : name_(std::move(name)) {}

  /// Appends the numbers of the completed lines. A line that is not a number takes the time of a
  /// sample and becomes NaN. Skips empty lines.
  void add(std::span<const std::byte> bytes, std::vector<double>& samples);
  /// Appends the last number at the end of the stream: the last line may lack its line end.
  void finish(std::vector<double>& samples);
  void restart();

  /// Returns the number of bytes of an incomplete line.
  [[nodiscard]] std::size_t waiting() const { return line_.size(); }
  [[nodiscard]] std::uint64_t garbled() const { return garbled_; }
  /// Returns place and text of the first line that is not a number; empty if there is none.
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
