#include "text/html_page.hpp"

#include <cstdint>
#include <string_view>

#include "base/sha256.hpp"

namespace piae::text {

namespace {

std::string in_base64(const std::string& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      three = three << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

/// Returns the hash of an inline source in the syntax of a Content-Security-Policy.
std::string source_hash(const std::string& text) {
  return "'sha256-" + in_base64(Sha256().update(text).finish()) + "'";
}

}  // namespace

std::string document(const std::string& title, const Style& style, const Html& body) {
  const std::string policy = "default-src 'none'; img-src data:; style-src " +
                             source_hash(style.css) + "; script-src " + source_hash(style.script);
  const Html head =
      void_element("meta", {{"charset", "utf-8"}}) +
      void_element("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", policy}}) +
      void_element("meta",
                   {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}) +
      void_element("meta", {{"name", "color-scheme"}, {"content", "light dark"}}) +
      void_element("link", {{"rel", "icon"}, {"href", "data:,"}}) + element("title", title) +
      element("style", Html::markup(style.css));
  const Html page =
      element("head", head) +
      element("body", element("a", {{"class", "skip"}, {"href", "#content"}}, "To the content") +
                          body + element("script", Html::markup(style.script)));
  return "<!DOCTYPE html>\n" + element("html", {{"lang", "en"}}, page).text() + "\n";
}

}  // namespace piae::text
