#include "settings/lists.hpp"

#include <sstream>

#include "base/error.hpp"

namespace piae::settings {

void refuse(const std::filesystem::path& file, const toml::node& node, const std::string& what) {
  std::ostringstream line;
  line << file.string() << ", line " << node.source().begin.line << ": " << what;
  throw Error(Exit::bad_input, line.str());
}

std::string holds(const std::string& list, const std::string& word, const std::string& what) {
  return list + " holds '" + word + "'" + what;
}

std::vector<std::string> words_in(const toml::table& table, const std::string& list) {
  std::vector<std::string> words;
  const toml::array* nodes = table[list].as_array();
  if (nodes == nullptr) return words;
  for (const toml::node& node : *nodes) words.push_back(node.value_or<std::string>(""));
  return words;
}

}  // namespace piae::settings
