#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace piae::storm {

/// A reader of the product, and what stands for it outside this process.
struct Target {
  const char* name;  ///< of its folder in inputs/
  /// Reads a file as a program does. Throws what the reader throws; returns normally where the file
  /// is accepted.
  void (*read)(const std::filesystem::path& file);
  /// Reads the file by libraries that are not ours and may crash: only the program must not.
  bool by_libraries;
};

std::span<const Target> targets();

/// Why the programs, run on a file that ends this process, do not treat it as promised; empty where
/// they do: exit 65, and one line that names it.
std::string failure_of_programs(const Target& target, const std::filesystem::path& file,
                                const std::filesystem::path& programs);

}  // namespace piae::storm
