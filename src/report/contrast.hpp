#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/paired_rows.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// One of the two sides that are set beside each other: a dataset of a run.
struct Side {
  std::filesystem::path run;
  std::string dataset;
  std::string protocol;           ///< of its splits
  std::vector<AccuracyRow> rows;  ///< with their mean_rows
};

/// The cells of a grid in a folder RUN/DATASET, which names the dataset. Throws as resolve() and
/// run::require_all().
Side read_side(const std::filesystem::path& folder, run::GridOptions options);

/// What a condition is worth: the accuracies with it minus those without it, by method and ratio.
struct Contrast {
  Side with;
  Side without;
  std::vector<PairedRow> rows;  ///< of both sides' methods, by method, then ratio, then the mean
};

/// Both sides are of the same methods, ratios and seeds. Throws Error(usage) when nothing tells
/// them apart.
Contrast contrast(Side with, Side without);

/// with,without,method,ratio,with_mean,with_std,without_mean,without_std and paired_header(). Sides
/// are named by what differs: dataset, protocol, or else the run.
std::string contrast_csv(const Contrast& contrast);
Document contrast_document(const Contrast& contrast);

}  // namespace piae::report
