#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// Cells that are missing for the same reason.
struct HoleGroup {
  std::string dataset = {};
  HoleState state = HoleState::not_begun;
  std::string stage = {};                 ///< the one that is not done
  std::vector<std::string> methods = {};  ///< in the order of the grid, as run::name_by() has them
  std::vector<std::string> ratios = {};   ///< of the diagnoses among them
  std::vector<std::int64_t> seeds = {};   ///< ascending
  std::size_t diagnoses = 0;
  std::size_t scores = 0;
  std::vector<std::string> reasons = {};  ///< each once
  std::vector<std::filesystem::path> logs = {};
};

/// The holes in groups: those that failed or are refused first, each method and stage a group of
/// its own; what is not begun is one group for each data set.
std::vector<HoleGroup> groups_of(const std::vector<DatasetContents>& datasets);

/// "failed", "refused", ...
std::string word_of(HoleState state);

/// "vae and wgan-gp; 10:1 and 1:1; seeds 0 to 4": which cells they are.
std::string cells_label(const HoleGroup& group);

/// "3 of 20 cells are missing: 1 failed, 2 not begun"; or that all are there.
std::string completeness(const std::vector<DatasetContents>& datasets);

/// The first thing that a page shows: what is missing, and why; or that nothing is.
Html problems_html(const std::vector<DatasetContents>& datasets);

}  // namespace piae::page
