#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::page {

/// A piece of HTML. Strings passed as Html are escaped, so that no name of a class, file or method
/// can turn into markup.
class Html {
 public:
  Html() = default;
  Html(const std::string& plain);  // NOLINT(google-explicit-constructor): see above
  Html(const char* plain);         // NOLINT(google-explicit-constructor)

  /// Takes text without escaping. Use it only for markup of this program and for the user's own
  /// style sheet and script.
  static Html markup(std::string text);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool empty() const { return text_.empty(); }
  Html& operator+=(const Html& other);

 private:
  std::string text_;
};

Html operator+(Html first, const Html& second);
/// Returns all pieces in a row.
Html joined(const std::vector<Html>& pieces);

/// An attribute. The value is plain text; element() escapes it.
struct Attribute {
  std::string name;
  std::string value;
};
using Attributes = std::vector<Attribute>;

/// Returns "<name attributes>content</name>".
Html element(const std::string& name, const Attributes& attributes, const Html& content);
Html element(const std::string& name, const Attributes& attributes,
             const std::vector<Html>& content);
Html element(const std::string& name, const Html& content);
/// Returns "<name attributes>", for elements that HTML never closes, such as img and meta.
Html void_element(const std::string& name, const Attributes& attributes);

/// Returns the address of a file relative to the page. It starts with "./" and is URL-escaped, so
/// that a colon in a name does not make it an absolute address.
std::string address_of(const std::filesystem::path& file);

/// Returns a link to a file that shows its path.
Html file_link(const std::filesystem::path& file);
Html file_link(const std::filesystem::path& file, const Html& shown);

/// Returns an address that contains the text ("data:text/csv;charset=utf-8,..."), so that the page
/// does not depend on another file. `type` is the media type. Text with single quotes gives shorter
/// addresses.
std::string data_address(const std::string& type, const std::string& text);

/// Returns a name for an anchor: letters, digits and hyphens.
std::string anchor(const std::string& name);

}  // namespace piae::page
