#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::storm {

/// An artefact of the corpus and the stage that reads it, with its options.
struct Consumer {
  std::string file;
  std::string stage;
  std::vector<std::string> options;
  /// True if damage is not an error: training restarts after a damaged checkpoint and reports it.
  [[nodiscard]] bool starts_anew() const { return file.ends_with(".checkpoint"); }
};

/// Reads the file `consumers` of corpus.sh with lines "FILE STAGE OPTION...".
std::vector<Consumer> read_consumers(const std::filesystem::path& corpus);

}  // namespace piae::storm
