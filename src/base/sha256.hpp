#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace piae {

/// SHA-256 (FIPS 180-4, by OpenSSL) of all bytes given to update(), in their order.
class Sha256 {
 public:
  Sha256();
  Sha256& update(std::span<const std::byte> bytes);
  Sha256& update(std::string_view text);
  /// The 32 bytes of the digest. The object cannot be used afterwards.
  std::string finish();
  /// The digest as 64 lower-case hexadecimal digits. The object cannot be used afterwards.
  std::string finish_hex();

 private:
  struct Free {
    void operator()(void* context) const;
  };
  std::unique_ptr<void, Free> context_;
};

/// Hexadecimal SHA-256 of a file's bytes. Throws Error(input_missing) where it cannot be read, or
/// is no file.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace piae
