#include "page/commented_toml.hpp"

#include <spdlog/fmt/fmt.h>

#include <string_view>

#include "cli/toml_file.hpp"
#include "text/lines.hpp"

namespace piae::page {

namespace {

/// Where the comment of a line begins: at the first # outside of quotes.
std::size_t begin_of_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote != 0) {
      if (line[i] == quote) quote = 0;
    } else if (line[i] == '"' || line[i] == '\'') {
      quote = line[i];
    } else if (line[i] == '#') {
      return i;
    }
  }
  return std::string_view::npos;
}

std::string comment_of(std::string_view line) {
  const std::size_t begin = begin_of_comment(line);
  if (begin == std::string_view::npos) return "";
  const std::size_t text = line.find_first_not_of("# ", begin);
  return text == std::string_view::npos ? "" : std::string(line.substr(text));
}

/// A comment that goes on from the line above: nothing before it but spaces.
bool goes_on(std::string_view line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first != std::string_view::npos && first > 0 && line[first] == '#';
}

std::string joined_values(const toml::array& array) {
  std::string text;
  for (const toml::node& node : array) text += (text.empty() ? "" : ", ") + plain_value(node);
  return text;
}

std::string joined_values(const toml::table& table) {
  std::string text;
  for (const auto& [key, node] : table) {
    text += (text.empty() ? "" : "; ") + std::string(key.str()) + " = " + plain_value(node);
  }
  return text;
}

}  // namespace

CommentedToml::CommentedToml(const std::filesystem::path& file)
    : values_(cli::parse_toml_file(file)), lines_(text::read_lines(file)) {}

std::string CommentedToml::comment_beside(const toml::node& node) const {
  std::size_t i = node.source().begin.line;  // counts from 1; 0 where the parser does not know
  if (i == 0 || i > lines_.size()) return "";
  std::string comment = comment_of(lines_[i - 1]);
  for (; !comment.empty() && i < lines_.size() && goes_on(lines_[i]); ++i) {
    comment += " " + comment_of(lines_[i]);
  }
  return comment;
}

std::string plain_value(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_integer()) return std::to_string(number->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (const auto* array = node.as_array()) return joined_values(*array);
  if (const auto* table = node.as_table()) return joined_values(*table);
  return "";  // dates, which no setting is
}

}  // namespace piae::page
