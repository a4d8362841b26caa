#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/range.hpp"

namespace piae::signal {

/// One table of a description, read strictly: keys must be known, required keys present, types
/// right. All errors are one line with the file, the line and the key (Error(bad_input);
/// Error(input_missing) if the file is missing).
///
///     TomlTable root("pipeline/datasets/cwru.toml");
///     name = root.text("name");
///     for (TomlTable& record : root.tables("record")) { ...; record.finish(); }
///     root.finish();
class TomlTable {
 public:
  /// Reads a whole description by read_description_file().
  explicit TomlTable(const std::filesystem::path& file);

  [[nodiscard]] bool has(const std::string& key) const { return table_->contains(key); }

  std::string text(const std::string& key);  ///< not empty, one line
  std::string optional_text(const std::string& key);
  double number(const std::string& key, const Range& range);  ///< integers are accepted
  std::optional<double> optional_number(const std::string& key, const Range& range);
  std::int64_t integer(const std::string& key, const Range& range);

  std::vector<std::string> texts(const std::string& key);          ///< at least one
  std::vector<std::string> text_or_texts(const std::string& key);  ///< or a single text
  std::vector<std::string> optional_texts(const std::string& key);

  TomlTable table(const std::string& key);                          ///< [key]
  std::optional<TomlTable> optional_table(const std::string& key);  ///< [key]
  std::vector<TomlTable> tables(const std::string& key);            ///< [[key]], at least one
  std::vector<TomlTable> optional_tables(const std::string& key);

  /// Refuses keys that no call has requested. Call it after reading all keys of the table.
  void finish() const;

  /// Refuses keys other than these. Call it before the first read, where a key may be missing
  /// because another one stands for it.
  void require_only(const std::vector<std::string>& keys);

  /// Returns a hint at the key that seems to stand for a missing one; empty if none does.
  [[nodiscard]] std::string given_for(const std::string& missing) const;

  /// Returns the plain table for other readers. Its keys are not checked.
  [[nodiscard]] const toml::table& plain() const { return *table_; }

  /// Throws Error(bad_input): "<file>, line <n>: <table>.<key> <what>".
  [[noreturn]] void refuse(const std::string& key, const std::string& what) const;

 private:
  struct File {
    std::string name;
    toml::table root;
  };
  TomlTable(std::shared_ptr<const File> file, const toml::table* table, std::string name)
      : file_(std::move(file)), table_(table), name_(std::move(name)) {}

  const toml::node& node(const std::string& key);
  [[nodiscard]] std::string checked(const std::string& key, const std::string& text) const;

  std::shared_ptr<const File> file_;
  const toml::table* table_;
  std::string name_;                  ///< "record"; empty for the whole file
  std::set<std::string> known_keys_;  ///< keys requested so far
};

}  // namespace piae::signal
