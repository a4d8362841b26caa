#include "cli/toml_file.hpp"

#include <string>
#include <string_view>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "base/one_line.hpp"
#include "cli/toml_text.hpp"

namespace piae::cli {

toml::table parse_toml_file(const std::filesystem::path& file) {
  const Bytes bytes = artefact::read_file(file, most_toml_bytes);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  try {
    return parse_toml(text, file.string());
  } catch (const NotToml& error) {
    throw Error(Exit::bad_input, one_line(file.string() + ", line " + std::to_string(error.line()) +
                                          ": " + error.what()));
  }
}

}  // namespace piae::cli
