#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::text {

/// A table as it is to be stored.
struct File {
  std::filesystem::path path;
  std::string text;
};

/// Writes all, each beside its place and renamed. Where one cannot be written, those before it go
/// too: tables of two runs must not stand together. Throws Error(failed).
void save_all(const std::vector<File>& files);

}  // namespace piae::text
