#include "raw/uff_functions.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>

#include "base/numbers.hpp"
#include "raw/csv_fields.hpp"
#include "raw/file.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

bool is_mark(std::string_view line) {
  return line.starts_with("    -1") && trimmed(line.substr(6), blanks).empty();
}

/// Returns `width` columns of a line without surrounding blanks.
std::string_view columns(std::string_view line, std::size_t begin, std::size_t width) {
  return trimmed(line.substr(std::min(begin, line.size())).substr(0, width), blanks);
}

class UffScan {
 public:
  UffScan(const fs::path& file, std::string_view text) : file_(file), rest_(text) {}

  std::vector<UffFunction> run() {
    while (!trimmed(rest_, " \t\r\n\x1a").empty()) {
      const std::string_view line = take();
      if (trimmed(line, blanks).empty()) continue;
      if (!is_mark(line)) refuse_here("no data set begins here");
      const std::string_view type = take();
      types_.emplace_back(columns(type, 0, 6));
      if (types_.back() == "58") {
        functions_.push_back(function(type));
      } else {
        (void)until_mark();
      }
    }
    if (functions_.empty()) {
      refuse_file(file_, "has no time record (data set 58); it has data sets " + listed(types_));
    }
    return std::move(functions_);
  }

 private:
  [[noreturn]] void refuse_here(const std::string& what) const {
    refuse_file(file_, fmt::format("truncated or damaged: {} (line {}, data set {} of type 58)",
                                   what, line_, functions_.size() + 1));
  }

  std::string_view take() {
    if (rest_.empty()) refuse_here("it ends within a data set");
    ++line_;
    return take_line(rest_);
  }

  /// Returns the lines before the end mark of a data set; takes the mark, too.
  std::string_view until_mark() {
    const std::string_view begin = rest_;
    for (;;) {
      const std::size_t size = begin.size() - rest_.size();
      if (is_mark(take())) return begin.substr(0, size);
    }
  }

  template <class T>
  T number(std::string_view line, std::size_t begin, std::size_t width) const {
    const std::string_view field = columns(line, begin, width);
    const auto value = number_in<T>(field);
    if (!value) refuse_here(fmt::format("its header holds '{}', not a number", field));
    return *value;
  }

  /// Reads the eleven lines of a header and the values.
  UffFunction function(std::string_view type) {
    constexpr std::size_t lines = 11;
    std::array<std::string_view, lines> header;
    for (std::string_view& line : header) line = take();
    UffFunction function{.name = std::string(trimmed(header[0], blanks)),
                         .function_type = number<int>(header[5], 0, 5),
                         .ordinate_type = number<int>(header[6], 0, 10),
                         .count = number<std::size_t>(header[6], 10, 10),
                         .is_even = number<int>(header[6], 20, 10) == 1,
                         .increment = number<double>(header[6], 43, 13),
                         .abscissa_type = number<int>(header[7], 0, 10),
                         .is_binary = columns(type, 6, 1) == "b",
                         .first_line = line_ + 1};
    if (!function.is_binary) {
      function.values = until_mark();
      return function;
    }
    if (number<std::size_t>(type, 19, 12) != lines) {
      refuse_here("its header does not have 11 lines");
    }
    take_bytes(function, type);
    return function;
  }

  void take_bytes(UffFunction& function, std::string_view type) {
    constexpr int big_endian = 2;
    constexpr int ieee = 2;
    if (number<int>(type, 13, 6) != ieee) {
      refuse_file(file_, fmt::format("data set {} has numbers of a DEC or IBM computer, which are "
                                     "not supported; export it as text, type 58",
                                     functions_.size() + 1));
    }
    function.is_big_endian = number<int>(type, 7, 6) == big_endian;
    const auto bytes = number<std::size_t>(type, 31, 12);
    if (bytes > rest_.size()) refuse_here("it has fewer bytes than it declares");
    function.values = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    rest_.remove_prefix(std::min(rest_.find_first_not_of("\r\n"), rest_.size()));
    if (rest_.empty() || !is_mark(take())) refuse_here("its values do not end where it declares");
  }

  const fs::path& file_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::vector<std::string> types_;
  std::vector<UffFunction> functions_;
};

}  // namespace

std::vector<UffFunction> uff_functions(const fs::path& file, std::string_view text) {
  return UffScan(file, text).run();
}

}  // namespace piae::raw
