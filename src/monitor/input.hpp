#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace piae::monitor {

/// The bytes of a stream: standard input, a pipe, or a file that may be growing.
class Input {
 public:
  /// "-" is standard input. With `follow` a file does not end where it ends now: more is waited
  /// for. Throws Error(input_missing) for a file that is not there or cannot be read, and
  /// Error(usage) for a terminal, and for a pipe that is to be followed, which has an end of its
  /// own.
  Input(const std::filesystem::path& path, bool follow);
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  ~Input();

  enum class Event {
    bytes,   ///< these
    none,    ///< there were none for a fifth of a second, or a signal came
    broken,  ///< a followed file was cut or replaced: what comes next is its new beginning
    end,
  };
  struct Piece {
    Event event = Event::none;
    std::span<const std::byte> bytes;
  };

  /// Waits for what comes next. Throws Error(input_missing) where it cannot be read.
  Piece read(std::span<std::byte> buffer);

  /// As it is called in messages.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  [[nodiscard]] bool begins_anew();
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::string name_;
  bool follow_;
  int descriptor_;
};

}  // namespace piae::monitor
