#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace piae::plan {

/// Lists of names, and the words of a command.
using Words = std::vector<std::string>;

bool has(const Words& words, const std::string& word);

void append(Words& words, const Words& more);

/// Appends --option and its values; appends nothing without values.
void append_option(Words& words, const std::string& option, const Words& values);

/// Joins the words with blanks.
std::string spaced(const Words& words);

/// Splits a text into words at blanks, commas and line breaks.
Words words_in(const std::string& text);

/// Splits a line at a separator.
Words fields_of(const std::string& line, char separator);

/// Returns a path without the leading results/RUN/.
std::string below_run(const std::string& path);

/// Returns the name of a file without its folders.
std::string file_name(const std::string& path);

/// Returns the seeds as texts.
Words texts_of(const std::vector<std::int64_t>& seeds);

/// Returns the paths of files with these names in one folder.
Words in_folder(const std::string& folder, const Words& names);

/// Formats a time for people: "12 s", "4 min", "1 h 01 min".
std::string duration(double seconds);

}  // namespace piae::plan
