#include "signal/described_file.hpp"

#include <algorithm>
#include <filesystem>

namespace piae::signal {

namespace fs = std::filesystem;

void require_file_name(const TomlTable& table, const std::string& name) {
  const fs::path path(name);
  if (path.is_absolute() || std::ranges::find(path, fs::path("..")) != path.end()) {
    table.refuse("file", "must be a path below the data folder");
  }
  if (path.filename().empty() || path.filename() == ".") {
    table.refuse("file", "must end with the name of a file");
  }
  if (name.front() == '-') table.refuse("file", "must not begin with '-'");
}

std::vector<std::string> read_file_names(TomlTable& record) {
  std::vector<std::string> names = record.text_or_texts("file");
  for (const std::string& name : names) require_file_name(record, name);
  return names;
}

std::string read_variable(TomlTable& table, const std::string& key) {
  constexpr std::size_t longest = 1000;
  std::string variable = table.text(key);
  if (variable.size() > longest) {
    table.refuse(key, "must have at most " + std::to_string(longest) + " characters");
  }
  return variable;
}

}  // namespace piae::signal
