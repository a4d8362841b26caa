#include "signal/toml_table.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "signal/description_file.hpp"
#include "signal/meant_key.hpp"

namespace piae::signal {

TomlTable::TomlTable(const std::filesystem::path& file)
    : file_(std::make_shared<File>(File{file.string(), read_description_file(file)})),
      table_(&file_->root) {}

const toml::node& TomlTable::node(const std::string& key) {
  known_keys_.insert(key);
  const toml::node* node = table_->get(key);
  if (node == nullptr) refuse(key, "is missing" + given_for(key));
  return *node;
}

std::string TomlTable::given_for(const std::string& missing) const {
  for (const auto& [key, node] : *table_) {
    const std::string given(key.str());
    if (known_keys_.contains(given)) continue;
    const std::string meant = meant_key(given, {missing});
    if (!meant.empty()) return fmt::format("; instead of {}, {}", given, meant);
  }
  return {};
}

std::string TomlTable::text(const std::string& key) {
  const auto* text = node(key).as_string();
  if (text == nullptr) refuse(key, "must be a text in quotes");
  return checked(key, text->get());
}

std::string TomlTable::checked(const std::string& key, const std::string& text) const {
  if (text.empty()) refuse(key, "is empty");
  if (has_control_characters(text)) refuse(key, "holds a control character");
  return text;
}

std::string TomlTable::optional_text(const std::string& key) {
  known_keys_.insert(key);
  return has(key) ? text(key) : std::string();
}

double TomlTable::number(const std::string& key, const Range& range) {
  const auto value = node(key).is_number() ? node(key).value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value)) refuse(key, "must be a finite number");
  if (!range.holds(*value)) refuse(key, range.rule());
  return *value;
}

std::vector<std::string> TomlTable::texts(const std::string& key) {
  const toml::array* array = node(key).as_array();
  if (array == nullptr || array->empty() || !array->is_homogeneous<std::string>()) {
    refuse(key, "must be a list of one or more texts in quotes");
  }
  std::vector<std::string> texts;
  for (const toml::node& element : *array) {
    texts.push_back(checked(key, element.as_string()->get()));
  }
  return texts;
}

std::vector<std::string> TomlTable::text_or_texts(const std::string& key) {
  return node(key).is_array() ? texts(key) : std::vector{text(key)};
}

std::vector<std::string> TomlTable::optional_texts(const std::string& key) {
  known_keys_.insert(key);
  return has(key) ? texts(key) : std::vector<std::string>{};
}

std::optional<double> TomlTable::optional_number(const std::string& key, const Range& range) {
  known_keys_.insert(key);
  return has(key) ? std::optional(number(key, range)) : std::nullopt;
}

std::int64_t TomlTable::integer(const std::string& key, const Range& range) {
  const auto* value = node(key).as_integer();
  if (value == nullptr) refuse(key, "must be a whole number");
  if (!range.holds(static_cast<double>(value->get()))) refuse(key, range.rule());
  return value->get();
}

TomlTable TomlTable::table(const std::string& key) {
  const toml::table* inner = node(key).as_table();
  if (inner == nullptr) refuse(key, "must be a table, [" + key + "]");
  return {file_, inner, key};
}

std::optional<TomlTable> TomlTable::optional_table(const std::string& key) {
  known_keys_.insert(key);
  return has(key) ? std::optional(table(key)) : std::nullopt;
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) {
  const toml::array* array = node(key).as_array();
  if (array == nullptr || array->empty() || !array->is_homogeneous<toml::table>()) {
    refuse(key, "must be a list of tables, [[" + key + "]]");
  }
  std::vector<TomlTable> tables;
  for (const toml::node& element : *array) {
    tables.push_back(TomlTable(file_, element.as_table(), key));
  }
  return tables;
}

std::vector<TomlTable> TomlTable::optional_tables(const std::string& key) {
  known_keys_.insert(key);
  return has(key) ? tables(key) : std::vector<TomlTable>{};
}

void TomlTable::finish() const {
  for (const auto& [key, node] : *table_) {
    const std::string name(key.str());
    if (known_keys_.contains(name)) continue;
    const std::string meant = meant_key(name, known_keys_);
    refuse(name, meant.empty()
                     ? fmt::format("is unknown; known keys are {}", fmt::join(known_keys_, ", "))
                     : "is unknown; " + meant);
  }
}

void TomlTable::require_only(const std::vector<std::string>& keys) {
  known_keys_.insert(keys.begin(), keys.end());
  finish();
}

void TomlTable::refuse(const std::string& key, const std::string& what) const {
  const toml::node* node = table_->get(key);
  const toml::source_region& place = node != nullptr ? node->source() : table_->source();
  std::ostringstream text;
  text << (place.path ? *place.path : file_->name);
  if (place.begin.line > 0) text << ", line " << place.begin.line;
  text << ": " << (name_.empty() ? key : name_ + "." + key) << ' ' << what;
  throw Error(Exit::bad_input, one_line(text.str()));
}

}  // namespace piae::signal
