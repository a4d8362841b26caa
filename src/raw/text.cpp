#include "raw/text.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "artefact/file.hpp"
#include "raw/csv_fields.hpp"
#include "raw/file.hpp"
#include "raw/limits.hpp"

namespace piae::raw {

namespace {

constexpr std::uint32_t first_high_surrogate = 0xD800;
constexpr std::uint32_t first_low_surrogate = 0xDC00;
constexpr std::uint32_t first_behind_surrogates = 0xE000;
constexpr std::uint32_t unknown_character = 0xFFFD;

void append_utf8(std::string& text, std::uint32_t c) {
  const auto byte = [&](std::uint32_t value) { text.push_back(static_cast<char>(value)); };
  if (c < 0x80) return byte(c);
  if (c < 0x800) {
    byte(0xC0 | c >> 6);
  } else {
    if (c < 0x10000) {
      byte(0xE0 | c >> 12);
    } else {
      byte(0xF0 | c >> 18);
      byte(0x80 | (c >> 12 & 0x3F));
    }
    byte(0x80 | (c >> 6 & 0x3F));
  }
  byte(0x80 | (c & 0x3F));
}

/// Converts UTF-16 to UTF-8. Half a surrogate pair becomes U+FFFD, because text never has one.
std::string from_utf16(std::string_view bytes, bool low_byte_first) {
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto a = static_cast<std::uint8_t>(bytes[i]);
    const auto b = static_cast<std::uint8_t>(bytes[i + 1]);
    return low_byte_first ? a | b << 8U : b | a << 8U;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    std::uint32_t c = unit(i);
    if (c >= first_high_surrogate && c < first_behind_surrogates) {
      const std::uint32_t next = i + 3 < bytes.size() ? unit(i + 2) : 0;
      const bool is_pair =
          c < first_low_surrogate && next >= first_low_surrogate && next < first_behind_surrogates;
      if (is_pair) i += 2;
      c = is_pair ? 0x10000 + ((c - first_high_surrogate) << 10) + (next - first_low_surrogate)
                  : unknown_character;
    }
    append_utf8(text, c);
  }
  return text;
}

/// Drops the ends that old editors and loggers write: nulls, Ctrl-Z, blank lines. Keeps the line
/// end of the last line, because a text cut within a number has none.
void drop_empty_end(std::string& text) {
  const std::string what("\0\x1a", 2);
  bool has_line_end = false;
  while (!text.empty()) {
    if (what.find(text.back()) != std::string::npos) {
      text.pop_back();
      continue;
    }
    const std::size_t line = text.find_last_of('\n');
    const std::size_t begin = line == std::string::npos ? 0 : line + 1;
    const bool is_blank = text.find_first_not_of(" \t\r", begin) == std::string::npos;
    if (!is_blank || begin == 0) break;
    text.resize(begin - 1);
    has_line_end = true;
  }
  if (has_line_end) text.push_back('\n');
}

/// Converts line ends of the old Macintosh, which are CR alone. Editors may add an LF at the end.
void mend_line_ends(std::string& text) {
  const std::string_view empty_end(" \t\r\n\0\x1a", 6);
  const std::size_t first = std::min(text.find('\n'), text.size());
  if (text.find_first_not_of(empty_end, first) != std::string::npos) return;
  std::ranges::replace(text, '\r', '\n');
}

bool is_control(char c) { return (c >= '\0' && c < '\t') || (c > '\r' && c < ' ') || c == '\x7f'; }

/// Returns the place of the first control character from `begin` on; npos if there is none.
std::size_t find_control(std::string_view text, std::size_t begin) {
  const auto* const found = std::find_if(text.begin() + begin, text.end(), is_control);
  return found == text.end() ? std::string_view::npos
                             : static_cast<std::size_t>(found - text.begin());
}

[[noreturn]] void refuse_control(const std::filesystem::path& file, std::string_view text,
                                 std::size_t at) {
  const auto line = 1 + std::ranges::count(text.substr(0, at), '\n');
  refuse_file(fmt::format("{}, line {}", file.string(), line),
              fmt::format("holds the control character {:#04x}, as after a crash, so lines may be "
                          "missing; remove the characters, or get the file again",
                          static_cast<int>(text[at])));
}

/// True if a line with control characters is text that ends with a word, as in a header with fields
/// of a fixed length. Rows end with a number, also if a hole precedes it. A crash leaves whole
/// blocks of a disk, which are longer than fields.
bool is_header_with_control(std::string_view line) {
  constexpr std::size_t longest_padding = 255;
  const auto* const last = std::find_if(line.rbegin(), line.rend(), is_control).base();
  const std::string_view behind(last, static_cast<std::size_t>(line.end() - last));
  std::string_view end = trimmed(behind, " \t\r,;|\"");
  end.remove_prefix(end.find_last_of(" \t,;|") + 1);  // npos + 1 is 0
  return holds_letters(line) && !number_in_field(end) &&
         std::ranges::count_if(line, is_control) <= static_cast<long>(longest_padding);
}

/// Refuses control characters in lines that cannot be a header.
void require_control_in_header(const std::filesystem::path& file, std::string_view text) {
  std::size_t at = find_control(text, 0);
  while (at != std::string_view::npos) {
    const std::size_t begin = at == 0 ? 0 : text.find_last_of('\n', at) + 1;  // npos + 1 is 0
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (!is_header_with_control(text.substr(begin, end - begin))) refuse_control(file, text, at);
    at = find_control(text, end);
  }
}

/// True if nearly every other byte is 0, as for numbers and Latin letters in UTF-16. A few other
/// characters, such as the ² of a unit, may stand among them.
bool is_utf16(std::string_view text) {
  std::array<std::size_t, 2> zeros{};
  std::size_t letters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\0') ++zeros.at(i % 2);
    if (text[i] >= '\t' && text[i] < '\x7f') ++letters;
  }
  const std::size_t most = text.size() / 2;
  const std::size_t enough = most - most / 8;
  return most > 1 && std::ranges::min(zeros) == 0 && std::ranges::max(zeros) + 1 >= enough &&
         letters >= enough;
}

bool is_in_no_text(char c) { return c >= '\0' && c < ' ' && (c < '\b' || c > '\r') && c != '\x1a'; }

/// Refuses text in UTF-16 without a byte order mark, and binary files.
void require_text(const std::filesystem::path& file, std::string_view text) {
  constexpr std::size_t enough = 64;
  const std::string_view begin = text.substr(0, text.find_last_not_of('\0') + 1).substr(0, enough);
  if (is_utf16(begin)) {
    refuse_file(file, "seems to be UTF-16 without a byte order mark; save it as UTF-8");
  }
  if (std::ranges::count_if(begin, is_in_no_text) > 2) {
    refuse_file(file,
                "is binary, in an unsupported format; export it as text, WAV or HDF5, or, if it "
                "holds only samples, convert it: np.save('x.npy', np.fromfile(FILE, dtype='<f4'))");
  }
}

}  // namespace

std::string without_byte_order_mark(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return from_utf16(bytes.substr(2), true);
  if (bytes.starts_with("\xFE\xFF")) return from_utf16(bytes.substr(2), false);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  return std::string(bytes);
}

std::string read_text(const std::filesystem::path& file) {
  const Bytes bytes = artefact::read_file(file, largest_bytes);
  std::string text =
      without_byte_order_mark({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  require_text(file, text);
  mend_line_ends(text);
  drop_empty_end(text);
  require_control_in_header(file, text);
  return text;
}

void require_no_control_characters(const std::filesystem::path& file, std::string_view text,
                                   std::size_t begin) {
  const std::size_t at = find_control(text, begin);
  if (at != std::string_view::npos) refuse_control(file, text, at);
}

std::string with_blanks_for_control(std::string_view text) {
  if (find_control(text, 0) == std::string_view::npos) return {};
  std::string plain(text);
  std::ranges::replace_if(plain, is_control, ' ');
  return plain;
}

}  // namespace piae::raw
