#pragma once

#include <filesystem>
#include <string>

#include "text/html.hpp"

namespace piae::page {

using text::Attributes;
using text::element;
using text::Html;
using text::joined;
using text::void_element;

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
