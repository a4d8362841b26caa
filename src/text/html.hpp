#pragma once

#include <string>
#include <vector>

namespace piae::text {

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

}  // namespace piae::text
