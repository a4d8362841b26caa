#include "text/wrap.hpp"

#include <sstream>

namespace piae::text {

std::string wrap(const std::string& paragraph, std::size_t widest, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::istringstream words(paragraph);
  std::string text;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > widest) {
      text += line + '\n';
      line.clear();
    }
    line += (line.empty() ? margin : " ") + word;
  }
  return text + line + '\n';
}

}  // namespace piae::text
