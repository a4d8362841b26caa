#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

/// Writes TDMS files according to NI's description ("TDMS File Format Internal Structure").
namespace piae::tdms {

// Bits of a segment's table of contents.
inline constexpr std::uint32_t metadata = 1U << 1U;
inline constexpr std::uint32_t new_list = 1U << 2U;
inline constexpr std::uint32_t raw_data = 1U << 3U;
inline constexpr std::uint32_t interleaved = 1U << 5U;
inline constexpr std::uint32_t big_endian = 1U << 6U;
inline constexpr std::uint32_t daqmx = 1U << 7U;
inline constexpr std::uint32_t new_values = metadata | new_list | raw_data;

inline constexpr std::uint64_t crashed = 0xFFFFFFFFFFFFFFFF;

// Types of values.
inline constexpr std::uint32_t nothing = 0;
inline constexpr std::uint32_t int8 = 1;
inline constexpr std::uint32_t int16 = 2;
inline constexpr std::uint32_t int32 = 3;
inline constexpr std::uint32_t int64 = 4;
inline constexpr std::uint32_t uint8 = 5;
inline constexpr std::uint32_t uint16 = 6;
inline constexpr std::uint32_t uint32 = 7;
inline constexpr std::uint32_t uint64 = 8;
inline constexpr std::uint32_t single = 9;
inline constexpr std::uint32_t dbl = 10;
inline constexpr std::uint32_t text = 0x20;
inline constexpr std::uint32_t time_stamp = 0x44;

class Writer {
 public:
  explicit Writer(bool is_big = false) : is_big_(is_big) {}

  template <class T>
  [[nodiscard]] std::string number(T value) const {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (is_big_ != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
    return bytes;
  }
  template <class T>
  [[nodiscard]] std::string numbers(const std::vector<T>& values) const {
    std::string bytes;
    for (const T value : values) bytes += number(value);
    return bytes;
  }
  [[nodiscard]] std::string words(const std::string& value) const {
    return number(static_cast<std::uint32_t>(value.size())) + value;
  }

  [[nodiscard]] std::string property(const std::string& name, double value) const {
    return words(name) + number(dbl) + number(value);
  }
  [[nodiscard]] std::string property(const std::string& name, std::uint32_t value) const {
    return words(name) + number(uint32) + number(value);
  }
  [[nodiscard]] std::string property(const std::string& name, const std::string& value) const {
    return words(name) + number(text) + words(value);
  }

  // Return the index of an object's values.
  [[nodiscard]] std::string index(std::uint32_t type, std::uint64_t count) const {
    return number(std::uint32_t{20}) + number(type) + number(std::uint32_t{1}) + number(count);
  }
  [[nodiscard]] std::string index_of_text(std::uint64_t count, std::uint64_t bytes) const {
    return number(std::uint32_t{28}) + number(text) + number(std::uint32_t{1}) + number(count) +
           number(bytes);
  }
  [[nodiscard]] std::string no_values() const { return number(std::uint32_t{0xFFFFFFFF}); }
  [[nodiscard]] std::string as_before() const { return number(std::uint32_t{0}); }

  [[nodiscard]] std::string object(const std::string& path, const std::string& index,
                                   const std::vector<std::string>& properties = {}) const {
    std::string bytes = words(path) + index + number(static_cast<std::uint32_t>(properties.size()));
    for (const std::string& one : properties) bytes += one;
    return bytes;
  }

  /// Returns a segment. `size` is its recorded length; 0 for the correct one.
  [[nodiscard]] std::string segment(std::uint32_t contents, const std::vector<std::string>& objects,
                                    const std::string& raw, std::uint64_t size = 0) const {
    std::string about;
    if ((contents & metadata) != 0) about = number(static_cast<std::uint32_t>(objects.size()));
    for (const std::string& object : objects) about += object;
    if (size == 0) size = about.size() + raw.size();
    const std::string table =  // always little-endian
        Writer(false).number(contents | (is_big_ ? big_endian : 0U));
    return "TDSm" + table + number(std::uint32_t{4713}) + number(size) +
           number(std::uint64_t{about.size()}) + about + raw;
  }

 private:
  bool is_big_;
};

}  // namespace piae::tdms
