#include "page/document.hpp"

#include "base/error.hpp"
#include "text/file.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

/// Reads a file to inline. Removes carriage returns, because browsers convert line ends to line
/// feeds before they compare a script's hash.
std::string read_inlined(const fs::path& file, const std::string& element) {
  std::string text = text::read_file(file);
  std::erase(text, '\r');
  if (text.find("</" + element) != std::string::npos) {
    throw Error(Exit::bad_input,
                file.string() + ": contains '</" + element +
                    "', which would end it early in the page; split the text in two");
  }
  return text;
}

}  // namespace

Style read_style(const fs::path& folder) {
  return {.css = read_inlined(folder / "style.css", "style"),
          .script = read_inlined(folder / "script.js", "script")};
}

}  // namespace piae::page
