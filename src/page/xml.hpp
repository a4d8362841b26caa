#pragma once

#include <optional>
#include <string>
#include <vector>

namespace piae::page {

/// An element of an XML document, or a text in it. Attributes and text are as they were written,
/// with their escapes.
struct XmlNode {
  struct Attribute {
    std::string name;
    std::string value;
    bool operator==(const Attribute&) const = default;
  };

  std::string name;  ///< empty for a text
  std::vector<Attribute> attributes = {};
  std::string text = {};
  std::vector<XmlNode> children = {};

  /// The value of an attribute; null where there is none.
  [[nodiscard]] const std::string* find(const std::string& attribute) const;
};

/// Reads as much of XML as pictures are written in: elements and texts; comments, declarations, and
/// line feeds and tabs between elements are left out. Empty for anything else, such as an element
/// that is not closed.
std::optional<XmlNode> parse_xml(const std::string& text);

/// The element as text, attributes in single quotes.
std::string xml_text(const XmlNode& node);

}  // namespace piae::page
