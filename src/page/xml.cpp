#include "page/xml.hpp"

#include <algorithm>
#include <string_view>

namespace piae::page {

namespace {

constexpr std::string_view xml_spaces = " \t\r\n";

/// Reads from the front of what is left. Every member returns false where the text is not as it
/// should be.
class XmlParser {
 public:
  explicit XmlParser(std::string_view text) : left_(text) {}

  bool document(XmlNode& root) {
    return skip_what_is_no_element() && element(root) && skip_what_is_no_element() && left_.empty();
  }

 private:
  bool take(std::string_view word) {
    if (!left_.starts_with(word)) return false;
    left_.remove_prefix(word.size());
    return true;
  }
  bool take_until(std::string_view end, std::string_view& taken) {
    const std::size_t at = left_.find(end);
    if (at == std::string_view::npos) return false;
    taken = left_.substr(0, at);
    left_.remove_prefix(at + end.size());
    return true;
  }
  void skip_spaces() {
    left_.remove_prefix(std::min(left_.find_first_not_of(xml_spaces), left_.size()));
  }

  bool skip_what_is_no_element() {
    std::string_view skipped;
    for (skip_spaces(); !left_.empty(); skip_spaces()) {
      if (take("<?")) {
        if (!take_until("?>", skipped)) return false;
      } else if (take("<!--")) {
        if (!take_until("-->", skipped)) return false;
      } else if (take("<!")) {
        if (!take_until(">", skipped)) return false;
      } else {
        return true;
      }
    }
    return true;
  }

  bool name(std::string& name) {
    const std::size_t end = std::min(left_.find_first_of(" \t\r\n=/>"), left_.size());
    name = left_.substr(0, end);
    left_.remove_prefix(end);
    return !name.empty();
  }

  bool attribute(XmlNode& node) {
    XmlNode::Attribute attribute;
    if (!name(attribute.name)) return false;
    skip_spaces();
    if (!take("=")) return false;
    skip_spaces();
    const std::string_view quote = left_.substr(0, 1);
    if (quote != "'" && quote != "\"") return false;
    left_.remove_prefix(1);
    std::string_view value;
    if (!take_until(quote, value)) return false;
    attribute.value = value;
    node.attributes.push_back(std::move(attribute));
    return true;
  }

  bool element(XmlNode& node) {
    if (!take("<") || !name(node.name)) return false;
    for (skip_spaces(); !take(">"); skip_spaces()) {
      if (take("/>")) return true;
      if (!attribute(node)) return false;
    }
    return content(node);
  }

  bool content(XmlNode& node) {
    while (!take("</" + node.name)) {
      if (left_.empty()) return false;
      if (left_.starts_with("<!--")) {
        std::string_view comment;
        if (!take_until("-->", comment)) return false;
      } else if (left_.starts_with("<")) {
        if (!element(node.children.emplace_back())) return false;
      } else {
        add_text(node);
      }
    }
    skip_spaces();
    return take(">");
  }

  void add_text(XmlNode& node) {
    const std::string_view text = left_.substr(0, left_.find('<'));
    left_.remove_prefix(text.size());
    const bool between_elements = text.find_first_not_of(xml_spaces) == std::string_view::npos &&
                                  text.find_first_of("\t\n") != std::string_view::npos;
    if (!between_elements) node.children.push_back({.name = "", .text = std::string(text)});
  }

  std::string_view left_;
};

void append(const XmlNode& node, std::string& text) {
  if (node.name.empty()) {
    text += node.text;
    return;
  }
  text += '<' + node.name;
  for (const XmlNode::Attribute& attribute : node.attributes) {
    const char quote = attribute.value.find('\'') == std::string::npos ? '\'' : '"';
    text += ' ' + attribute.name + '=' + quote + attribute.value + quote;
  }
  if (node.children.empty()) {
    text += "/>";
    return;
  }
  text += '>';
  for (const XmlNode& child : node.children) append(child, text);
  text += "</" + node.name + '>';
}

}  // namespace

const std::string* XmlNode::find(const std::string& attribute) const {
  const auto found = std::ranges::find(attributes, attribute, &Attribute::name);
  return found == attributes.end() ? nullptr : &found->value;
}

std::optional<XmlNode> parse_xml(const std::string& text) {
  XmlNode root;
  if (!XmlParser(text).document(root)) return std::nullopt;
  return root;
}

std::string xml_text(const XmlNode& node) {
  std::string text;
  append(node, text);
  return text;
}

}  // namespace piae::page
