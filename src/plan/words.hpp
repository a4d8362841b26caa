#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace piae::plan {

/// Lists of names, and the words of a command.
using Words = std::vector<std::string>;

bool has(const Words& words, const std::string& word);

void append(Words& words, const Words& more);

/// Appends --option and its values; nothing where there are none.
void append_option(Words& words, const std::string& option, const Words& values);

/// The words with blanks between them.
std::string spaced(const Words& words);

/// The words of a text; blanks, commas and line breaks stand between them.
Words words_in(const std::string& text);

/// The parts of a line between separators.
Words fields_of(const std::string& line, char separator);

/// A path without results/RUN/ in front.
std::string below_run(const std::string& path);

/// The name of a file without its folders.
std::string file_name(const std::string& path);

/// The numbers of seeds.
Words texts_of(const std::vector<std::int64_t>& seeds);

/// Files of these names in one folder.
Words in_folder(const std::string& folder, const Words& names);

/// A time for people: "12 s", "4 min", "1 h 01 min".
std::string duration(double seconds);

}  // namespace piae::plan
