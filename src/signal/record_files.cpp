#include "signal/record_files.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <iterator>

namespace piae::signal {

namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Removes the digits at the front of a text and returns them without leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto* const end = std::ranges::find_if_not(text, is_digit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

std::vector<fs::path> matching_in(const fs::path& root, const fs::path& folder,
                                  const std::string& pattern) {
  std::vector<fs::path> found;
  std::error_code none;
  for (auto entry = fs::directory_iterator(root / folder, none); entry != fs::directory_iterator();
       entry.increment(none)) {
    const std::string name = entry->path().filename().string();
    if (matches(pattern, name)) found.push_back(folder / name);
  }
  return found;
}

/// Returns the matching regular files below `root`, folder by folder.
std::vector<std::string> matching(const std::string& pattern, const fs::path& root) {
  std::vector<fs::path> paths{fs::path()};
  for (const fs::path& part : fs::path(pattern)) {
    std::vector<fs::path> longer;
    for (const fs::path& path : paths) {
      if (!is_pattern(part.string())) {
        longer.push_back(path / part);
      } else {
        std::ranges::move(matching_in(root, path, part.string()), std::back_inserter(longer));
      }
    }
    paths = std::move(longer);
  }
  std::error_code none;
  std::erase_if(paths,
                [&](const fs::path& path) { return !fs::is_regular_file(root / path, none); });
  std::vector<std::string> files;
  files.reserve(paths.size());
  for (const fs::path& path : paths) files.push_back(path.string());
  std::ranges::sort(files, naturally_less);
  return files;
}

}  // namespace

bool matches(const std::string& pattern, const std::string& path) {
  std::string escaped;
  for (const char c : pattern) escaped += c == '[' ? "[[]" : std::string(1, c);
  return ::fnmatch(escaped.c_str(), path.c_str(), FNM_NOESCAPE | FNM_PATHNAME | FNM_PERIOD) == 0;
}

bool is_pattern(std::string_view name) {
  return name.find_first_of("*?") != std::string_view::npos;
}

bool naturally_less(std::string_view left, std::string_view right) {
  const auto both = std::pair(left, right);
  while (!left.empty() && !right.empty()) {
    if (is_digit(left.front()) && is_digit(right.front())) {
      const std::string_view a = take_number(left);
      const std::string_view b = take_number(right);
      if (a.size() != b.size()) return a.size() < b.size();
      if (a != b) return a < b;
    } else {
      if (left.front() != right.front()) return left.front() < right.front();
      left.remove_prefix(1);
      right.remove_prefix(1);
    }
  }
  if (left.empty() != right.empty()) return left.empty();
  return both.first < both.second;  // they differ only in leading zeros
}

std::vector<std::string> files_of(const std::vector<std::string>& names, const fs::path& folder) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    if (is_pattern(name)) {
      std::ranges::move(matching(name, folder), std::back_inserter(files));
    } else {
      files.push_back(name);
    }
  }
  return files;
}

}  // namespace piae::signal
