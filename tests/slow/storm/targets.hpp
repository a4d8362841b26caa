#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace piae::storm {

/// A reader of the product.
struct Target {
  const char* name;  ///< its folder in inputs/
  /// Reads a file as a program does. Throws the reader's exception, or returns if the file is
  /// accepted.
  void (*read)(const std::filesystem::path& file);
  /// True if external libraries read the file: they may crash, but the programs may not.
  bool by_libraries;
};

std::span<const Target> targets();

/// Runs the programs on a file that ends this process. Returns how they break the promise of exit
/// 65 and one line with the file's name; "" if they keep it.
std::string failure_of_programs(const Target& target, const std::filesystem::path& file,
                                const std::filesystem::path& programs);

}  // namespace piae::storm
