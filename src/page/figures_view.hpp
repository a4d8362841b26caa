#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "page/html.hpp"

namespace piae::page {

/// A file that a page may hold within itself. Where it does not, it links it.
struct Attachment {
  std::filesystem::path file = {};  ///< below the folder of the run; empty where there is none
  std::string address = {};         ///< a data address that holds it
  bool held = false;                ///< whether the page holds it
};

/// A picture of a figure, and the numbers that it was drawn from.
struct Picture {
  std::string part = {};  ///< what of the figure it shows, such as a class; empty for all of it
  Attachment svg = {};
  int width = 0;  ///< of the picture's own size, in pixels; 0 where it does not say
  int height = 0;
  Attachment csv = {};
  std::filesystem::path pdf = {};  ///< below the folder of the run; empty where there is none
};

/// A figure of figures::catalogue(), of one data set.
struct FigureContents {
  std::string name = {};
  std::string paper = {};
  std::string title = {};
  std::string caption = {};
  std::string from = {};
  std::vector<Picture> pictures = {};  ///< those that are drawn
  std::string missing = {};            ///< why there is none; empty where there are pictures
  bool is_left_out = false;            ///< there is none, as the run is without what it shows
};

/// The figures of a data set in the folder of a run, in the order of the catalogue.
std::vector<FigureContents> read_figures(const std::filesystem::path& run,
                                         const std::string& dataset);

/// Chooses what the page holds so that all of it is not longer than so many bytes: pictures come
/// first, and the smaller before the larger.
void choose_attachments(const std::vector<FigureContents*>& figures, std::size_t most_bytes);

/// The figures of a data set: each with an anchor, a caption that says how to read it, its numbers
/// to save and where they came from; then those that are missing, and why.
Html figures_view(const std::string& dataset, const std::vector<FigureContents>& figures);

}  // namespace piae::page
