#include "text/html.hpp"

#include <algorithm>
#include <string_view>

#include "text/escape.hpp"

namespace piae::text {

namespace {

/// Elements that end a line, so that the file can be read and compared line by line.
constexpr std::string_view on_lines_of_their_own[] = {
    "body", "dd",    "details", "div",   "dl",     "dt",     "figcaption", "figure", "footer",
    "h1",   "h2",    "h3",      "head",  "header", "img",    "li",         "link",   "main",
    "meta", "nav",   "ol",      "p",     "rect",   "script", "section",    "style",  "summary",
    "svg",  "table", "tbody",   "thead", "title",  "tr",     "ul"};

std::string line_end_after(const std::string& name) {
  const bool ends =
      std::ranges::find(on_lines_of_their_own, name) != std::end(on_lines_of_their_own);
  return ends ? "\n" : "";
}

std::string attributes_text(const Attributes& attributes) {
  std::string text;
  for (const Attribute& attribute : attributes) {
    text += " " + attribute.name + "=\"" + text::markup_text(attribute.value) + "\"";
  }
  return text;
}

}  // namespace

Html::Html(const std::string& plain) : text_(text::markup_text(plain)) {}
Html::Html(const char* plain) : text_(text::markup_text(plain)) {}

Html Html::markup(std::string text) {
  Html html;
  html.text_ = std::move(text);
  return html;
}

Html& Html::operator+=(const Html& other) {
  text_ += other.text_;
  return *this;
}

Html operator+(Html first, const Html& second) { return first += second; }

Html joined(const std::vector<Html>& pieces) {
  Html all;
  for (const Html& piece : pieces) all += piece;
  return all;
}

Html element(const std::string& name, const Attributes& attributes, const Html& content) {
  return Html::markup("<" + name + attributes_text(attributes) + ">" + content.text() + "</" +
                      name + ">" + line_end_after(name));
}

Html element(const std::string& name, const Attributes& attributes,
             const std::vector<Html>& content) {
  return element(name, attributes, joined(content));
}

Html element(const std::string& name, const Html& content) {
  return element(name, Attributes{}, content);
}

Html void_element(const std::string& name, const Attributes& attributes) {
  return Html::markup("<" + name + attributes_text(attributes) + ">" + line_end_after(name));
}

}  // namespace piae::text
