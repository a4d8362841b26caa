#include "raw/mat_elements.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "raw/bytes.hpp"

namespace piae::raw {

namespace {

constexpr std::uint32_t compressed = 15;  // miCOMPRESSED

bool is_big_endian(std::span<const std::byte> bytes) { return bytes[126] == std::byte{'M'}; }

const std::string bad_checksum = "the checksum of its compressed data does not match";
const std::string bad_structure = "the content of a variable contradicts its size or type";

/// Reads the bytes of an element in order. Throws the flaw as a string.
class Content {
 public:
  Content() = default;
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;
  virtual ~Content() = default;

  template <std::size_t size>
  std::array<std::byte, size> take() {
    std::array<std::byte, size> bytes{};
    next(bytes);
    at_ += size;
    return bytes;
  }
  void skip(std::uint64_t count) {
    std::array<std::byte, 1 << 16> passed{};
    for (; count > 0;) {
      const auto some = std::span(passed).first(std::min<std::uint64_t>(count, passed.size()));
      next(some);
      at_ += some.size();
      count -= some.size();
    }
  }
  /// Returns the number of bytes read so far.
  [[nodiscard]] std::uint64_t at() const { return at_; }
  /// Throws unless all bytes are read.
  virtual void finish() = 0;

 private:
  virtual void next(std::span<std::byte> to) = 0;

  std::uint64_t at_ = 0;
};

class Plain final : public Content {
 public:
  explicit Plain(std::span<const std::byte> bytes) : rest_(bytes) {}
  void finish() override {
    if (!rest_.empty()) throw bad_structure;
  }

 private:
  void next(std::span<std::byte> to) override {
    if (rest_.size() < to.size()) throw bad_structure;
    std::ranges::copy(rest_.first(to.size()), to.begin());
    rest_ = rest_.subspan(to.size());
  }

  std::span<const std::byte> rest_;
};

/// Unpacks a zlib stream without storing the output.
class Unpacked final : public Content {
 public:
  explicit Unpacked(std::span<const std::byte> packed) {
    if (inflateInit(&stream_) != Z_OK) throw bad_checksum;
    // zlib does not write to its input, but takes a pointer without const.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data()));
    stream_.avail_in = static_cast<uInt>(packed.size());
  }
  ~Unpacked() override { inflateEnd(&stream_); }
  Unpacked(const Unpacked&) = delete;
  Unpacked& operator=(const Unpacked&) = delete;

  void finish() override {
    std::byte more{};
    inflate_to({&more, 1});
    if (!ended_) throw bad_checksum;
    if (stream_.avail_out == 0) throw bad_structure;
  }

 private:
  void next(std::span<std::byte> to) override {
    inflate_to(to);
    if (stream_.avail_out > 0) throw ended_ ? bad_structure : bad_checksum;
  }
  void inflate_to(std::span<std::byte> to) {
    stream_.next_out = reinterpret_cast<Bytef*>(to.data());
    stream_.avail_out = static_cast<uInt>(to.size());
    while (stream_.avail_out > 0 && !ended_) {
      const int result = inflate(&stream_, Z_NO_FLUSH);
      if (result == Z_STREAM_END) ended_ = true;
      if (result != Z_OK && result != Z_STREAM_END) throw bad_checksum;
    }
  }

  z_stream stream_{};
  bool ended_ = false;
};

/// Types of numbers (mi...) and classes of arrays (mx...).
enum : std::uint32_t {
  mi_int32 = 5,
  mi_uint32 = 6,
  mi_single = 7,
  mi_double = 9,
  mi_int64 = 12,
  mi_uint64 = 13,
  mi_matrix = 14
};
enum : std::uint32_t {
  mx_cell = 1,
  mx_struct = 2,
  mx_object = 3,
  mx_double = 6,
  mx_single = 7,
  mx_int8 = 8,
  mx_uint64 = 15
};

/// Returns the bytes of a number of this type; 0 for other types.
std::uint32_t size_of_type(std::uint32_t type) {
  constexpr std::array<std::uint32_t, 14> sizes{0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8};
  return type < sizes.size() ? sizes[type] : 0;
}

/// Returns the type of a class of integers, from mxINT8 to mxUINT64.
std::uint32_t type_of_class(std::uint32_t array_class) {
  constexpr std::array<std::uint32_t, 8> types{1,        2,         3,        4,
                                               mi_int32, mi_uint32, mi_int64, mi_uint64};
  return types.at(array_class - mx_int8);
}

/// True if the class stores its values in this type: its own type or a smaller one that holds them.
bool may_store(std::uint32_t array_class, std::uint32_t type) {
  const bool is_64_bit_integer = type == mi_int64 || type == mi_uint64;
  if (array_class == mx_double) return size_of_type(type) > 0 && !is_64_bit_integer;
  if (array_class == mx_single) return size_of_type(type) > 0 && size_of_type(type) <= 4;
  const std::uint32_t own = type_of_class(array_class);
  if (type == mi_single || type == mi_double) return false;
  return type == own || (size_of_type(type) > 0 && size_of_type(type) < size_of_type(own));
}

struct Tag {
  std::uint32_t type = 0;
  std::uint32_t size = 0;     ///< content in bytes
  std::uint32_t padding = 0;  ///< bytes after the content
};

/// Checks the elements of one variable.
class Variables {
 public:
  Variables(Content& content, bool big_endian) : content_(content), big_endian_(big_endian) {}

  void matrix() { matrix(tag(), 0); }

 private:
  static constexpr int deepest = 64;

  std::uint32_t number() { return number_at(content_.take<4>(), 0, big_endian_); }

  /// Reads a tag. Content of up to 4 bytes is inside the tag, and the type's upper half is its
  /// size.
  Tag tag() {
    const std::uint32_t first = number();
    if (first >> 16 != 0) {
      const Tag small{.type = first & 0xffff, .size = first >> 16};
      if (small.size > 4) throw bad_structure;
      return {.type = small.type, .size = small.size, .padding = 4 - small.size};
    }
    const std::uint32_t size = number();
    return {.type = first, .size = size, .padding = first == mi_matrix ? 0 : (8 - size % 8) % 8};
  }
  void skip(const Tag& tag) { content_.skip(std::uint64_t{tag.size} + tag.padding); }

  std::uint64_t values_of(const Tag& dimensions) {
    if (dimensions.type != mi_int32 || dimensions.size % 4 != 0) throw bad_structure;
    std::uint64_t count = 1;
    for (std::uint32_t i = 0; i < dimensions.size / 4; ++i) {
      const std::uint64_t extent = number();
      if (extent != 0 && count > most_values / extent) throw bad_structure;
      count *= extent;
    }
    content_.skip(dimensions.padding);
    return count;
  }

  void values(std::uint32_t array_class, std::uint64_t count) {
    const Tag real = tag();
    if (!may_store(array_class, real.type) || real.size != count * size_of_type(real.type)) {
      throw bad_structure;
    }
    skip(real);
  }

  void parts(std::uint64_t count, int depth) {
    for (; count > 0; --count) matrix(tag(), depth + 1);
  }

  std::uint64_t fields() {
    const Tag length = tag();
    if (length.type != mi_int32 || length.size != 4) throw bad_structure;
    const std::uint32_t name_length = number();
    content_.skip(length.padding);
    const Tag names = tag();
    if (name_length == 0 || names.size % name_length != 0) throw bad_structure;
    skip(names);
    return names.size / name_length;
  }

  /// Checks numbers, structures and cell arrays; skips the content of other classes, such as text,
  /// sparse matrices and objects.
  void matrix(const Tag& whole, int depth) {
    if (whole.type != mi_matrix || depth > deepest) throw bad_structure;
    if (whole.size == 0) return;  // empty part
    const std::uint64_t end = content_.at() + whole.size;
    const Tag flags = tag();
    if (flags.type != mi_uint32 || flags.size != 8) throw bad_structure;
    const std::uint32_t flag = number();
    content_.skip(4);
    const std::uint32_t array_class = flag & 0xff;
    const bool is_complex = (flag & 0x0800) != 0;
    const bool is_numeric = array_class >= mx_double && array_class <= mx_uint64;
    const bool has_fields = array_class == mx_struct || array_class == mx_object;
    if (is_numeric || has_fields || array_class == mx_cell) {
      const std::uint64_t count = values_of(tag());
      skip(tag());  // name
      if (array_class == mx_object) skip(tag());
      for (int i = 0; is_numeric && i < (is_complex ? 2 : 1); ++i) values(array_class, count);
      if (array_class == mx_cell) parts(count, depth);
      if (has_fields) parts(fields() * count, depth);
    }
    if (content_.at() > end) throw bad_structure;
    content_.skip(end - content_.at());
  }

  static constexpr std::uint64_t most_values = 1ULL << 40;

  Content& content_;
  bool big_endian_;
};

}  // namespace

int mat_version(std::span<const std::byte> bytes) {
  if (bytes.size() < mat_header_bytes) return 0;
  const auto at = [&](std::size_t i) { return std::to_integer<int>(bytes[i]); };
  if (at(126) == 'M' && at(127) == 'I') return at(124) * 256 + at(125);
  if (at(126) == 'I' && at(127) == 'M') return at(125) * 256 + at(124);
  return 0;
}

bool is_whole_v5(std::span<const std::byte> bytes) {
  const bool big_endian = is_big_endian(bytes);
  std::size_t at = mat_header_bytes;
  while (at + 8 <= bytes.size()) at += 8 + number_at(bytes, at + 4, big_endian);
  return at == bytes.size();
}

std::string flaw_of_v5(std::span<const std::byte> bytes) {
  const bool big_endian = is_big_endian(bytes);
  try {
    for (std::size_t at = mat_header_bytes; at < bytes.size();) {
      const std::size_t size = number_at(bytes, at + 4, big_endian);
      const std::uint32_t type = number_at(bytes, at, big_endian);
      if (type == compressed) {
        Unpacked content(bytes.subspan(at + 8, size));
        Variables(content, big_endian).matrix();
        content.finish();
      } else if (type == mi_matrix) {
        Plain content(bytes.subspan(at, 8 + size));
        Variables(content, big_endian).matrix();
        content.finish();
      }
      at += 8 + size;
    }
  } catch (const std::string& flaw) {
    return flaw;
  }
  return {};
}

}  // namespace piae::raw
