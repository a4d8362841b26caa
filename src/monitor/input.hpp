#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace piae::monitor {

/// The bytes of a stream: standard input, a pipe, or a file that may be growing.
class Input {
 public:
  /// Opens `path`; "-" is standard input. With `follow`, waits for more at the end of the file.
  /// Throws Error(input_missing) if the file is missing or unreadable. Throws Error(usage) for a
  /// terminal, and for a pipe with `follow`, because a pipe has an end of its own.
  Input(const std::filesystem::path& path, bool follow);
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  ~Input();

  enum class Event {
    bytes,   ///< bytes came
    none,    ///< no bytes for 0.2 s, or a signal came
    broken,  ///< a followed file was cut or replaced: next come the bytes of its new beginning
    end,
  };
  struct Piece {
    Event event = Event::none;
    std::span<const std::byte> bytes;
  };

  /// Waits for the next bytes or event. Throws Error(input_missing) if reading fails.
  Piece read(std::span<std::byte> buffer);

  /// Returns the name for messages.
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
