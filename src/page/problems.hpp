#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "page/contents.hpp"
#include "page/html.hpp"

namespace piae::page {

/// Cells that are missing for the same reason.
struct MissingGroup {
  std::string dataset = {};
  MissingState state = MissingState::not_started;
  std::string stage = {};                 ///< stage that is not done
  std::vector<std::string> methods = {};  ///< in the order of the grid, named by run::name_by()
  std::vector<std::string> ratios = {};   ///< ratios of the diagnoses
  std::vector<std::int64_t> seeds = {};   ///< ascending
  std::size_t diagnoses = 0;
  std::size_t scores = 0;
  std::vector<std::string> reasons = {};  ///< each once
  std::vector<std::filesystem::path> logs = {};
};

/// Returns the missing cells in groups, failed and refused ones first. Each method and stage is a
/// group; cells that were not started are one group for each data set.
std::vector<MissingGroup> groups_of(const std::vector<DatasetContents>& datasets);

/// Returns "failed", "refused", ...
std::string word_of(MissingState state);

/// Returns the cells of a group: "vae and wgan-gp; 10:1 and 1:1; seeds 0 to 4".
std::string cells_label(const MissingGroup& group);

/// Returns "3 of 20 cells are missing: 1 failed, 2 not started", or that none is missing.
std::string completeness(const std::vector<DatasetContents>& datasets);

/// Returns the top of a page: what is missing and why, or that nothing is.
Html problems_html(const std::vector<DatasetContents>& datasets);

}  // namespace piae::page
