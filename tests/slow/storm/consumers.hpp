#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::storm {

/// An artefact of the corpus and the stage that reads it, with the options that it is given.
struct Consumer {
  std::string file;
  std::string stage;
  std::vector<std::string> options;
  /// A checkpoint that is damaged is no error: the training starts anew and says so.
  [[nodiscard]] bool starts_anew() const { return file.ends_with(".checkpoint"); }
};

/// Reads `consumers`, which corpus.sh writes: a line each, "FILE STAGE OPTION...".
std::vector<Consumer> read_consumers(const std::filesystem::path& corpus);

}  // namespace piae::storm
