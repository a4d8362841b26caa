#include "cli/toml_file.hpp"

#include <sstream>
#include <string_view>

#include "artefact/file.hpp"
#include "base/error.hpp"

namespace piae::cli {

toml::table parse_toml_file(const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = artefact::read_file(file);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    std::ostringstream line;
    line << file.string() << ", line " << error.source().begin.line
         << ": not valid TOML: " << error.description();
    throw Error(Exit::bad_input, line.str());
  }
}

}  // namespace piae::cli
