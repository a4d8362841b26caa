#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "page/html.hpp"

namespace piae::page {

/// A file that a page may include. Otherwise the page links to it.
struct Attachment {
  std::filesystem::path file = {};  ///< relative to the folder of the run; empty if none
  std::string address = {};         ///< data address that contains the file
  bool held = false;                ///< whether the page includes it
};

/// A picture of a figure and the numbers that it was drawn from.
struct Picture {
  std::string part = {};  ///< part of the figure, such as a class; empty for the whole figure
  Attachment svg = {};
  int width = 0;  ///< in pixels; 0 if the picture does not state its size
  int height = 0;
  Attachment csv = {};
  std::filesystem::path pdf = {};  ///< relative to the folder of the run; empty if none
};

/// A figure of figures::catalogue() for one data set.
struct FigureContents {
  std::string name = {};
  std::string paper = {};
  std::string title = {};
  std::string caption = {};
  std::string from = {};
  std::vector<Picture> pictures = {};  ///< drawn pictures
  std::string missing = {};            ///< why there are none; empty if there are pictures
  bool is_left_out = false;            ///< true if the run does not have what the figure shows
};

/// Returns the figures of a data set in the folder of a run, in the order of the catalogue.
std::vector<FigureContents> read_figures(const std::filesystem::path& run,
                                         const std::string& dataset);

/// Chooses the files that the page includes, with at most `most_bytes` in all. Pictures come before
/// numbers, small files before large ones.
void choose_attachments(const std::vector<FigureContents*>& figures, std::size_t most_bytes);

/// Returns the figures of a data set, each with an anchor, a caption that explains it, its numbers
/// to save and their source. The missing figures follow, with the reasons.
Html figures_view(const std::string& dataset, const std::vector<FigureContents>& figures);

}  // namespace piae::page
