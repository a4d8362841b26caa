#include "page/html.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "text/escape.hpp"

namespace piae::page {

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

bool is_letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

std::string percent_encoded(char c) {
  return fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
}

/// True if a character would end a data address, start a fragment or an escape, be dropped like a
/// line feed, or become longer when HTML escapes it.
bool must_be_encoded(char c) {
  return std::string_view("%#\"&<>\n\r\t").find(c) != std::string_view::npos;
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

std::string address_of(const std::filesystem::path& file) {
  std::string address = "./";
  for (const char c : file.generic_string()) {
    const bool plain =
        is_letter_or_digit(c) || std::string_view("/-_.~").find(c) != std::string::npos;
    address += plain ? std::string(1, c) : percent_encoded(c);
  }
  return address;
}

Html file_link(const std::filesystem::path& file) { return file_link(file, file.generic_string()); }

Html file_link(const std::filesystem::path& file, const Html& shown) {
  return element("a", {{"href", address_of(file)}}, shown);
}

std::string data_address(const std::string& type, const std::string& text) {
  std::string address = "data:" + type + ";charset=utf-8,";
  address.reserve(address.size() + text.size() + text.size() / 8);
  for (const char c : text) {
    if (must_be_encoded(c)) {
      address += percent_encoded(c);
    } else {
      address += c;
    }
  }
  return address;
}

std::string anchor(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (is_letter_or_digit(c)) {
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else {
      text += '-';
    }
  }
  return text;
}

}  // namespace piae::page
