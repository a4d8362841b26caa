#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace piae {

/// SHA-256 (FIPS 180-4, by OpenSSL) of all bytes passed to update(), in order.
class Sha256 {
 public:
  Sha256();
  Sha256& update(std::span<const std::byte> bytes);
  Sha256& update(std::string_view text);
  /// Returns the digest in 32 bytes. The object cannot be used afterwards.
  std::string finish();
  /// Returns the digest in 64 lower-case hexadecimal digits. The object cannot be used afterwards.
  std::string finish_hex();

 private:
  struct Free {
    void operator()(void* context) const;
  };
  std::unique_ptr<void, Free> context_;
};

/// Returns the hexadecimal SHA-256 of a file. Throws Error(input_missing) if it is not a regular
/// file or cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace piae
