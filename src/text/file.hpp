#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::text {

/// A text and the file that it will be written to.
struct File {
  std::filesystem::path path;
  std::string text;
};

/// Returns the bytes of a file. Throws Error as artefact::read_file() does.
std::string read_file(const std::filesystem::path& file);

/// Writes all files, each as artefact::write_file_atomically() does. Where one cannot be written,
/// those written before it are removed, so that tables of two runs never stand side by side, and
/// Error(failed) is thrown.
void save_all(const std::vector<File>& files);

/// Writes a file unless it holds that very text already, so that whatever make draws from it is not
/// drawn again.
void save_if_changed(const File& file);

}  // namespace piae::text
