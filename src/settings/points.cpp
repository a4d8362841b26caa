#include "settings/points.hpp"

#include <set>
#include <sstream>

#include "settings/lists.hpp"

namespace piae::settings {

namespace {

std::string twice(const std::string& factor) { return ", which sets " + factor + " twice"; }

}  // namespace

std::optional<Point> parse_point(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == word.size()) return std::nullopt;
  return Point{word.substr(0, equals), word.substr(equals + 1)};
}

void require_points(const std::filesystem::path& file, const toml::table& protocol,
                    const std::string& table, const std::string& list) {
  const std::string name = table + '.' + list;
  const toml::node* points = protocol.at_path(name).node();
  if (points == nullptr) return;
  if (!points->is_array()) refuse(file, *points, name + " must be a list");
  std::set<std::string> words;
  for (const toml::node& node : *points->as_array()) {
    const auto word = node.value_or<std::string>("");
    if (!words.insert(word).second) refuse(file, node, holds(name, word, " twice"));
    std::istringstream parts(word + '+');
    std::set<std::string> factors;
    for (std::string part; std::getline(parts, part, '+');) {
      const auto point = parse_point(part);
      if (!point) refuse(file, node, holds(name, word, ", which is not FACTOR=VALUE"));
      if (!factors.insert(point->factor).second) {
        refuse(file, node, holds(name, word, twice(point->factor)));
      }
    }
  }
}

std::vector<std::string> words_of(const toml::table& protocol, const std::string& table,
                                  const std::string& list) {
  const toml::table* own = protocol.at_path(table).as_table();
  return own == nullptr ? std::vector<std::string>{} : words_in(*own, list);
}

}  // namespace piae::settings
