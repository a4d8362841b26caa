#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "page/html.hpp"

namespace piae::page {

/// One setting that a run was made with.
struct Setting {
  std::string file;    ///< of the run: "train.piae-dt.toml"
  std::string option;  ///< "batch"; of a description also "bearing.balls" or "class IR007"
  std::string value;
  std::string source;  ///< what the comment beside it says, or that it is another now
};

/// The settings files of a run (results/RUN/.settings), in alphabetical order, each value with the
/// comment that stands beside it in pipeline/protocol.toml or pipeline/datasets/NAME.toml; where it
/// is stated by another description that this one is like, that is named before it. A value that
/// these no longer have has their value in the place of a source. Throws Error(bad_input) for a
/// file that is no TOML.
std::vector<Setting> read_settings(const std::filesystem::path& run,
                                   const std::filesystem::path& pipeline);

Html settings_view(const std::vector<Setting>& settings);

}  // namespace piae::page
