#include "text/lines.hpp"

#include <sstream>

#include "artefact/file.hpp"

namespace piae::text {

std::vector<std::string> read_lines(const std::filesystem::path& file) {
  const Bytes bytes = artefact::read_file(file);
  std::istringstream in(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace piae::text
