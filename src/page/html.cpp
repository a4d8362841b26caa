#include "page/html.hpp"

#include <spdlog/fmt/fmt.h>

#include <cctype>
#include <string_view>

namespace piae::page {

namespace {

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
