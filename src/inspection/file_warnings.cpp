#include "inspection/file_warnings.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>

#include "inspection/warning_text.hpp"

namespace piae::inspection {

namespace {

using Count = std::size_t FileCheck::*;

/// Returns the most frequent value of the files; the lower one of a tie.
std::size_t usual(const std::vector<FileCheck>& files, Count count) {
  std::map<std::size_t, std::size_t> files_by_count;
  for (const FileCheck& file : files) ++files_by_count[file.*count];
  return std::ranges::max_element(files_by_count, {},
                                  [](const auto& entry) { return entry.second; })
      ->first;
}

void add_odd(const RecordCheck& record, Count count, const std::string& what,
             const std::string& reason, std::vector<std::string>& lines) {
  constexpr std::size_t few = 3;
  const std::size_t most = usual(record.files, count);
  std::string names;
  std::size_t odd = 0;
  for (const FileCheck& file : record.files) {
    if (file.*count == most || ++odd > few) continue;
    names += fmt::format("{}{} has {}", names.empty() ? "" : ", ", file.name, file.*count);
  }
  if (odd == 0) return;
  if (odd > few) names += fmt::format(", and {} more differ", odd - few);
  lines.push_back(fmt::format("{}: most of its {} files have {} {}, but {}; {}",
                              place_of(record.source), record.files.size(), most, what, names,
                              reason));
}

}  // namespace

void add_odd_files(const RecordCheck& record, std::vector<std::string>& lines) {
  if (record.files.size() < 2) return;
  add_odd(record, &FileCheck::samples, "samples",
          "they may be cut off or recorded with other settings", lines);
  add_odd(record, &FileCheck::columns, "columns", "the variable may be another channel there",
          lines);
}

}  // namespace piae::inspection
