#include "text/escape.hpp"

#include <cctype>
#include <string_view>
#include <utility>

namespace piae::text {

namespace {

/// Brackets get braces because LaTeX reads a bracket at the start of a row as an option of the
/// preceding line break.
constexpr std::pair<std::string_view, std::string_view> latex_words[] = {
    {"\\", "\\textbackslash{}"},
    {"{", "\\{"},
    {"}", "\\}"},
    {"$", "\\$"},
    {"&", "\\&"},
    {"#", "\\#"},
    {"%", "\\%"},
    {"_", "\\_"},
    {"~", "\\textasciitilde{}"},
    {"^", "\\textasciicircum{}"},
    {"<", "\\textless{}"},
    {">", "\\textgreater{}"},
    {"|", "\\textbar{}"},
    {"[", "{[}"},
    {"]", "{]}"},
    {"±", "$\\pm$"},
    {"²", "$^2$"},
    {"–", "--"},
    {"†", "$\\dagger$"},
    {"‡", "$\\ddagger$"},
};

/// True if character i is the sign of a number at the start of the text, or after a space or
/// bracket.
bool is_sign(const std::string& text, std::size_t i) {
  const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '[';
  return begins && (text[i] == '+' || text[i] == '-') && i + 1 < text.size() &&
         std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0;
}

}  // namespace

std::string markdown_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\`*<|").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string markup_text(const std::string& text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string latex_text(const std::string& text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size();) {
    std::string_view from(&text[i], 1);
    std::string_view to = from;
    for (const auto& [plain, command] : latex_words) {
      if (!std::string_view(text).substr(i).starts_with(plain)) continue;
      from = plain;
      to = command;
    }
    escaped += is_sign(text, i) ? "$" + std::string(to) + "$" : std::string(to);
    i += from.size();
  }
  return escaped;
}

}  // namespace piae::text
