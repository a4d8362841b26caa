#include "base/bytes.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace piae {

void expect_much(void* begin, std::size_t bytes) {
  constexpr std::uintptr_t large_page = std::uintptr_t{2} << 20U;
  const auto from = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (from + large_page - 1) / large_page * large_page;
  const std::uintptr_t last = (from + bytes) / large_page * large_page;
  if (first >= last) return;
  // no effect on a system without large pages
  ::madvise(static_cast<std::byte*>(begin) + (first - from), last - first, MADV_HUGEPAGE);
}

Bytes::Bytes(std::size_t size)
    : bytes_(static_cast<std::byte*>(std::malloc(std::max<std::size_t>(size, 1)))), size_(size) {
  if (!bytes_) throw std::bad_alloc();
  expect_much(data(), size);
}

void Bytes::Free::operator()(std::byte* bytes) const { std::free(bytes); }

}  // namespace piae
