#pragma once

#include <cstddef>
#include <memory>

namespace piae {

/// Asks the system for large pages for memory that is about to be filled. With small pages, the
/// page faults take longer than the work on the bytes.
void expect_much(void* begin, std::size_t bytes);

/// Bytes of a file. Unlike a vector's, they are not zeroed before they are read.
class Bytes {
 public:
  Bytes() = default;
  /// Throws std::bad_alloc.
  explicit Bytes(std::size_t size);
  /// Takes ownership of memory from malloc().
  Bytes(void* allocated, std::size_t size)
      : bytes_(static_cast<std::byte*>(allocated)), size_(size) {}

  [[nodiscard]] std::byte* data() { return bytes_.get(); }
  [[nodiscard]] const std::byte* data() const { return bytes_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::byte* begin() { return data(); }
  [[nodiscard]] std::byte* end() { return data() + size_; }
  [[nodiscard]] const std::byte* begin() const { return data(); }
  [[nodiscard]] const std::byte* end() const { return data() + size_; }
  /// Keeps the first `size` bytes.
  void shorten(std::size_t size) { size_ = size; }

 private:
  struct Free {
    void operator()(std::byte* bytes) const;
  };
  std::unique_ptr<std::byte, Free> bytes_;
  std::size_t size_ = 0;
};

}  // namespace piae
