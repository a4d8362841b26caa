#include "plan/words.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string_view>

namespace piae::plan {

bool has(const Words& words, const std::string& word) {
  return std::ranges::count(words, word) > 0;
}

void append(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

void append_option(Words& words, const std::string& option, const Words& values) {
  if (values.empty()) return;
  words.push_back("--" + option);
  append(words, values);
}

std::string spaced(const Words& words) { return fmt::format("{}", fmt::join(words, " ")); }

Words words_in(const std::string& text) {
  constexpr std::string_view separators = ", \t\n";
  Words words;
  for (std::size_t end = 0;;) {
    const std::size_t first = text.find_first_not_of(separators, end);
    if (first == std::string::npos) return words;
    end = std::min(text.find_first_of(separators, first), text.size());
    words.push_back(text.substr(first, end - first));
  }
}

Words fields_of(const std::string& line, char separator) {
  Words fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, separator);) fields.push_back(field);
  return fields;
}

std::string below_run(const std::string& path) {
  const std::string results = "results/";
  if (!path.starts_with(results)) return path;
  const std::size_t run = path.find('/', results.size());
  return run == std::string::npos ? path : path.substr(run + 1);
}

std::string file_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

Words texts_of(const std::vector<std::int64_t>& seeds) {
  Words words;
  for (const std::int64_t seed : seeds) words.push_back(std::to_string(seed));
  return words;
}

Words in_folder(const std::string& folder, const Words& names) {
  Words files;
  for (const std::string& name : names) files.push_back(fmt::format("{}/{}", folder, name));
  return files;
}

std::string duration(double seconds) {
  if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
  if (seconds < 3570) return fmt::format("{:.0f} min", seconds / 60);
  const auto minutes = static_cast<std::int64_t>((seconds + 30) / 60);
  return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
}

}  // namespace piae::plan
