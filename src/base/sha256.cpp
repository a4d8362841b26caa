#include "base/sha256.hpp"

#include <openssl/evp.h>

#include <array>
#include <span>

#include "base/error.hpp"
#include "base/regular_file.hpp"

namespace piae {

namespace {

EVP_MD_CTX* as_context(void* context) { return static_cast<EVP_MD_CTX*>(context); }

void require(int ok) {
  if (ok != 1) throw Error(Exit::failed, "OpenSSL cannot compute SHA-256 on this machine");
}

}  // namespace

void Sha256::Free::operator()(void* context) const { EVP_MD_CTX_free(as_context(context)); }

Sha256::Sha256() : context_(EVP_MD_CTX_new()) {
  require(EVP_DigestInit_ex(as_context(context_.get()), EVP_sha256(), nullptr));
}

Sha256& Sha256::update(std::span<const std::byte> bytes) {
  require(EVP_DigestUpdate(as_context(context_.get()), bytes.data(), bytes.size()));
  return *this;
}

Sha256& Sha256::update(std::string_view text) {
  return update(std::as_bytes(std::span(text.data(), text.size())));
}

std::string Sha256::finish() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  require(EVP_DigestFinal_ex(as_context(context_.get()), digest.data(), &size));
  return {digest.begin(), digest.begin() + size};
}

std::string Sha256::finish_hex() {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string hex;
  for (const char c : finish()) {
    const auto byte = static_cast<unsigned char>(c);
    hex += digits[byte >> 4U];
    hex += digits[byte & 15U];
  }
  return hex;
}

std::string sha256_of_file(const std::filesystem::path& path) {
  const RegularFile file(path);
  Sha256 sha;
  std::array<std::byte, 1 << 16> buffer{};
  while (const std::size_t got = file.read(buffer)) sha.update(std::span(buffer).first(got));
  return sha.finish_hex();
}

}  // namespace piae
