#pragma once

#include <filesystem>
#include <string>

#include "page/html.hpp"

namespace piae::page {

/// The address of a file, relative to the page. It begins with "./" and is escaped as URLs are, so
/// that a colon in a name does not make it an address elsewhere.
std::string address_of(const std::filesystem::path& file);

/// A link to a file, which shows its path.
Html file_link(const std::filesystem::path& file);
Html file_link(const std::filesystem::path& file, const Html& shown);

/// A text as an address that holds it ("data:text/csv;charset=utf-8,..."), so that it needs no
/// other file. `type` is its media type. Where quotes are single, it is shorter in an attribute.
std::string data_address(const std::string& type, const std::string& text);

/// A name for an anchor: letters, digits and hyphens.
std::string anchor(const std::string& name);

}  // namespace piae::page
