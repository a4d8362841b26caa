#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::page {

/// A piece of HTML. Plain text becomes one by being escaped, wherever a string is passed as Html,
/// so no name of a class, file or method can turn into markup.
class Html {
 public:
  Html() = default;
  Html(const std::string& plain);  // NOLINT(google-explicit-constructor): see above
  Html(const char* plain);         // NOLINT(google-explicit-constructor)

  /// Takes text as it is. Only for what this program has written itself, and for the user's own
  /// style sheet and script.
  static Html markup(std::string text);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool empty() const { return text_.empty(); }
  Html& operator+=(const Html& other);

 private:
  std::string text_;
};

Html operator+(Html first, const Html& second);
/// All pieces in a row.
Html joined(const std::vector<Html>& pieces);

/// Escapes what has a meaning in HTML, in text as well as between double quotes, in which element()
/// puts the value of every attribute.
std::string escaped(const std::string& plain);

/// The value is plain text, and is escaped.
struct Attribute {
  std::string name;
  std::string value;
};
using Attributes = std::vector<Attribute>;

/// "<name attributes>content</name>".
Html element(const std::string& name, const Attributes& attributes, const Html& content);
Html element(const std::string& name, const Attributes& attributes,
             const std::vector<Html>& content);
Html element(const std::string& name, const Html& content);
/// "<name attributes>", for what HTML never closes, such as img and meta.
Html void_element(const std::string& name, const Attributes& attributes);

/// The address of a file, relative to the page. It begins with "./" and is escaped as URLs are, so
/// that a colon in a name does not make it an address elsewhere.
std::string address_of(const std::filesystem::path& file);

/// A link to a file, which shows its path.
Html file_link(const std::filesystem::path& file);
Html file_link(const std::filesystem::path& file, const Html& shown);

/// A text as an address that holds it ("data:text/csv;charset=utf-8,..."), so that it needs no
/// other file. `type` is its media type. Where quotes are single, it is shorter in an attribute.
std::string data_address(const std::string& type, const std::string& text);

/// A name for an anchor: letters, digits and hyphens.
std::string anchor(const std::string& name);

}  // namespace piae::page
