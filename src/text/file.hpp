#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::text {

/// A text and the path to write it to.
struct File {
  std::filesystem::path path;
  std::string text;
};

/// Returns the bytes of a file. Throws Error as artefact::read_file() does.
std::string read_file(const std::filesystem::path& file);

/// Writes all files, each as artefact::write_file_atomically() does. If one fails, removes those
/// written before, so that tables of two runs are never mixed, and throws Error(failed).
void save_all(const std::vector<File>& files);

/// Writes a file unless its text is unchanged, so that make does not redraw its pictures.
void save_if_changed(const File& file);

}  // namespace piae::text
